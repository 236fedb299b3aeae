#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <fstream>

#include "flexkey/mesh/error.h"
#include "flexkey/preview/images/draw.h"
#include "flexkey/preview/images/gif.h"
#include "flexkey/preview/images/image_file.h"
#include "flexkey/preview/images/image_format.h"
#include "flexkey/preview/images/resize.h"
#include "preview_images/test_folder.h"

namespace flexkey {
namespace {

using test::message_of;
using test::ramps;
using testing::HasSubstr;
using testing::StartsWith;

using ImageErrors = test::TestFolder;

TEST_F(ImageErrors, AnUnknownFormatNamesTheKnownOnes) {
  EXPECT_EQ(message_of([] { image_format("bmp"); }),
            "unknown picture format 'bmp'; use png, exr, webp or jpg");
  EXPECT_EQ(message_of([&] { write_picture(ramps(8, 8), folder() / "x.tga"); }),
            "unknown picture format 'tga'; use png, exr, webp or jpg");
  EXPECT_EQ(message_of([&] { write_picture(ramps(8, 8), folder() / "x"); }),
            "unknown picture format ''; use png, exr, webp or jpg");
  EXPECT_TRUE(names().empty());
}

TEST_F(ImageErrors, NoSizeAndTooLargeASizeAreRefusedBeforeAnyMemoryIsAsked) {
  EXPECT_EQ(message_of([&] { write_picture({}, folder() / "x.png"); }), "a picture of 0 x 0 pixels is empty");
  EXPECT_EQ(message_of([&] {
              write_picture({100000, 100000, {}}, folder() / "x.png");
            }),
            "a picture of 100000 x 100000 pixels is too large; at most 16384 a side and 100 million");
  EXPECT_THAT(message_of([] { blank_picture(16000, 16000, Rgb::Zero()); }), HasSubstr("too large"));
  EXPECT_THAT(message_of([] { resized(ramps(8, 8), 0, 8); }), HasSubstr("empty"));
  EXPECT_THAT(message_of([&] { GifWriter(folder() / "x.gif").add({-1, 8, {}}, 0); }), HasSubstr("empty"));
  EXPECT_TRUE(names().empty());
}

TEST_F(ImageErrors, AFullDiskIsSaid) {
  std::filesystem::create_symlink("/dev/full", folder() / "full.png");
  EXPECT_THROW(write_picture(ramps(64, 64), folder() / "full.png"), OutputError);
  EXPECT_EQ(message_of([&] { write_picture(ramps(64, 64), folder() / "full.png"); }),
            "cannot write '" + (folder() / "full.png").string() + "': No space left on device");
}

TEST_F(ImageErrors, AGifOnAFullDiskIsSaid) {
  std::filesystem::create_symlink("/dev/full", folder() / "full.gif");
  GifWriter gif(folder() / "full.gif");
  gif.add(ramps(64, 64), 0);
  EXPECT_THAT(message_of([&] { gif.finish(1); }), HasSubstr("full.gif': No space left on device"));
  EXPECT_THAT(names(), testing::ElementsAre("full.gif"));
}

TEST_F(ImageErrors, AFolderThatCannotBeWrittenIsSaid) {
  std::ofstream(folder() / "file") << "x";  // holds for every user, even one whom no permission stops
  EXPECT_THROW(write_picture(ramps(8, 8), folder() / "file" / "x.png"), OutputError);
  EXPECT_THAT(message_of([&] { write_picture(ramps(8, 8), folder() / "file" / "x.png"); }),
              HasSubstr("Not a directory"));
  EXPECT_THAT(message_of([&] { GifWriter(folder() / "file" / "x.gif").add(ramps(8, 8), 0); }),
              HasSubstr("Not a directory"));
  if (geteuid() == 0) return;
  ASSERT_EQ(chmod(folder().c_str(), 0555), 0);
  EXPECT_THAT(message_of([&] { write_picture(ramps(8, 8), folder() / "x.png"); }),
              HasSubstr("Permission denied"));
  ASSERT_EQ(chmod(folder().c_str(), 0755), 0);
}

TEST_F(ImageErrors, AGifNeedsFramesOfOneSize) {
  GifWriter gif(folder() / "x.gif");
  EXPECT_THAT(message_of([&] { gif.finish(1); }), HasSubstr("it has no frames"));
  gif.add(ramps(8, 8), 0);
  EXPECT_THAT(message_of([&] { gif.add(ramps(9, 8), 1); }), HasSubstr("9 x 8 pixels among frames of 8 x 8"));
}

TEST_F(ImageErrors, AFileThatIsNoPictureIsNamed) {
  std::ofstream(folder() / "text.png") << "not a picture";
  EXPECT_THAT(message_of([&] { read_picture(folder() / "text.png"); }),
              StartsWith("cannot read the picture '" + (folder() / "text.png").string() + "': "));
  EXPECT_THROW(read_picture(folder() / "none.png"), InputError);
}

}  // namespace
}  // namespace flexkey
