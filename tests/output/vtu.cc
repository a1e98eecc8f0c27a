// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#include <deal.II/base/utilities.h>

#include <gtest/gtest.h>
#include <zlib.h>

#include <setae/output/vtu.h>

#include <cstdint>
#include <cstring>

namespace
{
  using namespace Setae;

  template <typename Number>
  std::vector<Number>
  numbers(const std::string &encoded)
  {
    const auto          bytes = dealii::Utilities::decode_base64(encoded);
    std::vector<Number> result(bytes.size() / sizeof(Number));
    if (!result.empty())
      std::memcpy(result.data(), bytes.data(), bytes.size());
    return result;
  }

  /** The array of a file, as the format says how to read it. */
  template <typename Number>
  std::vector<Number>
  array(const std::string &file, const std::string &name)
  {
    const auto  tag    = file.find("Name=\"" + name + "\"");
    const auto  begin  = file.find('\n', tag) + 1;
    std::string text   = file.substr(begin, file.find('\n', begin) - begin);
    const auto  header = numbers<std::uint64_t>(text.substr(0, 32));
    if (header[0] == 0)
      {
        EXPECT_EQ(text.size(), 32u);
        return {};
      }
    // One block: four numbers of 8 bytes are 44 characters.
    EXPECT_EQ(header[0], 1u);
    const auto sizes = numbers<std::uint64_t>(text.substr(0, 44));
    const auto block = dealii::Utilities::decode_base64(text.substr(44));
    EXPECT_EQ(block.size(), sizes[3]);
    std::vector<Number> result(sizes[1] / sizeof(Number));
    uLongf              n_bytes = sizes[1];
    EXPECT_EQ(uncompress(reinterpret_cast<Bytef *>(result.data()),
                         &n_bytes,
                         block.data(),
                         block.size()),
              Z_OK);
    EXPECT_EQ(n_bytes, sizes[1]);
    return result;
  }
} // namespace



TEST(Vtu, KeepsEveryDigitFarFromTheOrigin)
{
  PointFields points;
  points.fields            = {{"force", 3}, {"gap", 1}};
  points.n_points_of_chain = 3;
  std::vector<double> positions, forces, gaps;
  for (unsigned int i = 0; i < 6; ++i)
    {
      for (unsigned int c = 0; c < 3; ++c)
        {
          positions.push_back(1e9 + 1e-6 * i + c);
          forces.push_back(1e-300 / (i + c + 1.));
        }
      gaps.push_back(-1. / (i + 3.));
      points.values.insert(points.values.end(),
                           positions.end() - 3,
                           positions.end());
      points.values.insert(points.values.end(), forces.end() - 3, forces.end());
      points.values.push_back(gaps.back());
    }
  const std::string file = vtu(points, "a test");
  EXPECT_EQ(array<double>(file, "Points"), positions);
  EXPECT_EQ(array<double>(file, "force"), forces);
  EXPECT_EQ(array<double>(file, "gap"), gaps);
}



TEST(Vtu, ChainsAreLinesThatDoNotMeet)
{
  PointFields points;
  points.n_points_of_chain = 3;
  points.values.assign(18, 0.);
  const std::string file = vtu(points, "a test");
  EXPECT_EQ(array<std::int64_t>(file, "connectivity"),
            (std::vector<std::int64_t>{0, 1, 1, 2, 3, 4, 4, 5}));
  EXPECT_EQ(array<std::int64_t>(file, "offsets"),
            (std::vector<std::int64_t>{2, 4, 6, 8}));
  EXPECT_EQ(array<std::uint8_t>(file, "types"),
            (std::vector<std::uint8_t>(4, 3)));
  EXPECT_NE(file.find("NumberOfPoints=\"6\" NumberOfCells=\"4\""),
            std::string::npos);
}



TEST(Vtu, WithoutPointsEveryArrayIsThereAndEmpty)
{
  PointFields points;
  points.fields          = {{"force", 3}};
  const std::string file = vtu(points, "a test");
  EXPECT_NE(file.find("NumberOfPoints=\"0\" NumberOfCells=\"0\""),
            std::string::npos);
  for (const char *const name :
       {"Points", "connectivity", "offsets", "types", "force"})
    EXPECT_TRUE(array<double>(file, name).empty()) << name;
}
