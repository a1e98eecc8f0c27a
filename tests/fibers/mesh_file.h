// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef tests_fibers_mesh_file_h
#define tests_fibers_mesh_file_h

#include <deal.II/base/tensor.h>

#include <gtest/gtest.h>

#include <cstdio>
#include <fstream>
#include <string>
#include <vector>

/** A file that is removed at the end; of its own for each test. */
struct TemporaryFile
{
  TemporaryFile(const std::string &text, const std::string &extension)
    : name(std::string(
             testing::UnitTest::GetInstance()->current_test_info()->name()) +
           extension)
  {
    std::ofstream(name) << text;
  }

  ~TemporaryFile()
  {
    std::remove(name.c_str());
  }

  const std::string name;
};

/** A mesh of lines as text of a VTK file. */
inline std::string
vtk_lines(const std::vector<dealii::Tensor<1, 3>>          &points,
          const std::vector<std::pair<unsigned, unsigned>> &lines,
          const unsigned int                                n_digits = 17)
{
  std::ostringstream file;
  file.precision(n_digits);
  file << "# vtk DataFile Version 3.0\nlines\nASCII\n"
       << "DATASET UNSTRUCTURED_GRID\nPOINTS " << points.size() << " double\n";
  for (const dealii::Tensor<1, 3> &p : points)
    file << p << '\n';
  file << "CELLS " << lines.size() << ' ' << 3 * lines.size() << '\n';
  for (const auto &[a, b] : lines)
    file << "2 " << a << ' ' << b << '\n';
  file << "CELL_TYPES " << lines.size() << '\n';
  for (unsigned int i = 0; i < lines.size(); ++i)
    file << "3\n";
  return file.str();
}

/** Lines from each point to the next one. */
inline std::vector<std::pair<unsigned, unsigned>>
chain_of(const unsigned int n_points)
{
  std::vector<std::pair<unsigned, unsigned>> lines;
  for (unsigned int i = 0; i + 1 < n_points; ++i)
    lines.emplace_back(i, i + 1);
  return lines;
}

#endif
