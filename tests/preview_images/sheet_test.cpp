#include "flexkey/preview/images/sheet.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "flexkey/preview/images/draw.h"
#include "flexkey/preview/images/resize.h"
#include "preview_images/test_folder.h"

namespace flexkey {
namespace {

using test::message_of;
using Sheets = test::TestFolder;

/// Cells that are told apart by their red: 0.01 for the first, 0.02 …
std::vector<Picture> cells(int count) {
  std::vector<Picture> cells;
  for (int i = 0; i < count; ++i)
    cells.push_back(blank_picture(96, 64, {0.01f * static_cast<float>(i + 1), 0, 0}));
  return cells;
}

const float* pixel(const Picture& picture, int x, int y) {
  return &picture.rgb[static_cast<std::size_t>(y * picture.width + x) * 3];
}

bool has_ink(const Picture& picture, const Rectangle& in) {
  for (int y = in.top; y < in.top + in.height; ++y)
    for (int x = in.left; x < in.left + in.width; ++x)
      if (pixel(picture, x, y)[1] < 0.5f) return true;
  return false;
}

TEST_F(Sheets, CellsLieRowByRowWithThinGapsOnWhite) {
  const Sheet sheet{3, cells(6), {"0 s", "1 s", "2 s"}, {"λ 0", "λ 1"}};
  const SheetLayout at = layout_of(sheet);
  const Picture picture = draw_sheet(sheet);
  ASSERT_EQ(picture.width, at.width);
  ASSERT_EQ(picture.height, at.height);
  EXPECT_EQ(picture.rgb.size(), static_cast<std::size_t>(at.width * at.height * 3));
  for (int i = 0; i < 6; ++i) {
    const int left = at.left + i % 3 * (96 + at.gap), top = at.top + i / 3 * (64 + at.gap);
    EXPECT_FLOAT_EQ(pixel(picture, left, top)[0], 0.01f * static_cast<float>(i + 1));
    EXPECT_FLOAT_EQ(pixel(picture, left + 95, top + 63)[0], 0.01f * static_cast<float>(i + 1));
    EXPECT_EQ(pixel(picture, left + 96, top)[1], 1) << "the gap is white";
  }
  EXPECT_EQ(at.left + 3 * 96 + 2 * at.gap + 2 * at.gap, at.width);
  EXPECT_LT(at.gap, 10);
}

TEST_F(Sheets, LabelsStandAboveTheirColumnsAndLeftOfTheirRows) {
  const Sheet sheet{3, cells(6), {"0 s", "1 s", "2 s"}, {"λ 0", "λ 1"}};
  const SheetLayout at = layout_of(sheet);
  const Picture picture = draw_sheet(sheet);
  for (int column = 0; column < 3; ++column)
    EXPECT_TRUE(has_ink(picture, {at.left + column * (96 + at.gap) + 32, 0, 32, at.top})) << column;
  for (int row = 0; row < 2; ++row)
    EXPECT_TRUE(has_ink(picture, {0, at.top + row * (64 + at.gap) + 16, at.left, 32})) << row;
  EXPECT_FALSE(has_ink(picture, {0, 0, at.left, at.top})) << "the corner is empty";
}

TEST_F(Sheets, ARowOfTimesNeedsNoLabelsAndAShortLastRowStaysWhite) {
  const Sheet row{4, cells(4), {}, {}};
  EXPECT_EQ(layout_of(row).left, layout_of(row).top);
  EXPECT_EQ(layout_of(row).width, 4 * 96 + 3 * layout_of(row).gap + 2 * layout_of(row).left);
  const Sheet shorter{2, cells(3), {}, {}};
  const SheetLayout at = layout_of(shorter);
  EXPECT_FALSE(has_ink(draw_sheet(shorter), {at.left + 96 + at.gap, at.top + 64 + at.gap, 96, 64}));
}

TEST_F(Sheets, WhatDoesNotFitIsAnError) {
  EXPECT_EQ(message_of([] { draw_sheet({}); }), "a sheet of no pictures");
  EXPECT_EQ(message_of([] {
              draw_sheet({2, cells(2), {"one"}, {}});
            }),
            "a sheet with 2 columns has 1 labels for them");
  Sheet mixed{2, cells(2), {}, {}};
  mixed.cells[1] = blank_picture(8, 8, Rgb::Zero());
  EXPECT_EQ(message_of([&] { draw_sheet(mixed); }), "a sheet with pictures of 96 x 64 and 8 x 8 pixels");
}

TEST_F(Sheets, PicturesAreMadeSmallerInLinearLight) {
  Picture checks = blank_picture(64, 64, Rgb::Zero());  // half of the light, whichever way it is looked at
  for (int y = 0; y < 64; ++y)
    for (int x = y % 2; x < 64; x += 2) fill(checks, {x, y, 1, 1}, {{1, 1, 1}});
  const Picture small = resized_to_width(checks, 16);
  EXPECT_EQ(small.height, 16);
  EXPECT_NEAR(pixel(small, 8, 8)[0], 0.5, 0.01);
}

TEST_F(Sheets, ResizingKeepsFlatColoursProportionsAndBlack) {
  const Picture small = resized_to_width(blank_picture(300, 200, {0.2f, 0.4f, 0.6f}), 90);
  EXPECT_EQ(small.width, 90);
  EXPECT_EQ(small.height, 60);
  for (std::size_t i = 0; i < small.rgb.size(); ++i)
    EXPECT_NEAR(small.rgb[i], 0.2f * static_cast<float>(i % 3 + 1), 1e-5);
  Picture edge = blank_picture(40, 40, Rgb::Zero());
  fill(edge, {20, 0, 20, 40}, {{10, 10, 10}});
  const Picture sharp = resized_to_width(edge, 20);
  EXPECT_GE(*std::min_element(sharp.rgb.begin(), sharp.rgb.end()), 0);
}

}  // namespace
}  // namespace flexkey
