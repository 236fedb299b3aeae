#include <OpenImageIO/imageio.h>

#include "flexkey/preview/images/module/codec.h"

/// What flexkey looks up in the module after loading it.
extern "C" const flexkey::ImageModule* flexkey_image_module() {
  static const flexkey::ImageModule module{FLEXKEY_VERSION,           flexkey::encode, flexkey::decode,
                                           flexkey::read_description, flexkey::resize, flexkey::text_coverage,
                                           flexkey::write_gif};
  OIIO::attribute("threads", 1);  // the program's own threads are enough
  return &module;
}
