# What a program that reads strangers' files should have: position-independent code, tables that are read-only once
# it runs, guarded stacks and checked copies.
include(CheckPIESupported)
check_pie_supported()
target_compile_options(flexkey_build INTERFACE -fstack-protector-strong)
if(NOT FLEXKEY_SANITIZE)
  target_compile_options(flexkey_build INTERFACE $<$<CONFIG:Release,RelWithDebInfo>:-U_FORTIFY_SOURCE>
    $<$<CONFIG:Release,RelWithDebInfo>:-D_FORTIFY_SOURCE=2>)
endif()
target_link_options(flexkey_build INTERFACE -Wl,-z,relro,-z,now)
