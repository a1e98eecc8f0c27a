// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#include <deal.II/base/utilities.h>

#include <setae/base/exceptions.h>
#include <setae/fibers/line_mesh.h>

#include <algorithm>
#include <fstream>
#include <iterator>

namespace Setae
{
  using namespace dealii;

  // GridIn takes the lines of a VTK file, but neither polylines nor points,
  // with which mesh generators and ParaView write curves, nor version 5.1.
  namespace
  {
    using Cells = std::vector<std::vector<unsigned int>>;

    /** The words of a file from the first data set on. */
    class Words
    {
    public:
      explicit Words(const std::string &file)
      {
        std::ifstream stream(file);
        std::string   version, title, format;
        std::getline(stream, version);
        std::getline(stream, title);
        std::getline(stream, format);
        AssertThrow(version.find("vtk DataFile") != std::string::npos,
                    ExcInput("its first line has no '# vtk DataFile'"));
        AssertThrow(Utilities::trim(format) == "ASCII",
                    ExcInput("it is '" + Utilities::trim(format) +
                             "', not ASCII"));
        words.assign(std::istream_iterator<std::string>(stream), {});
      }

      bool
      at_end() const
      {
        return position >= words.size();
      }

      /** Whether the next word is @p keyword, which is then skipped. */
      bool
      skip(const std::string &keyword)
      {
        const bool found = !at_end() && words[position] == keyword;
        position += found ? 1 : 0;
        return found;
      }

      std::string
      word()
      {
        AssertThrow(!at_end(), ExcInput("it ends too early"));
        return words[position++];
      }

      double
      real()
      {
        const std::string text = word();
        try
          {
            return Utilities::string_to_double(text);
          }
        catch (const ExceptionBase &)
          {
            AssertThrow(false, ExcInput("'" + text + "' is no number"));
          }
        return 0.;
      }

      unsigned int
      integer()
      {
        const double value = real();
        AssertThrow(value >= 0. && value < 4e9 &&
                      value == static_cast<unsigned int>(value),
                    ExcInput("'" + words[position - 1] +
                             "' is no number of a point or cell"));
        return static_cast<unsigned int>(value);
      }

    private:
      std::vector<std::string> words;
      std::size_t              position = 0;
    };

    /** The points of each cell, in the old format or that of version 5.1. */
    Cells
    read_cells(Words &words)
    {
      const unsigned int n = words.integer(), size = words.integer();
      Cells              cells;
      if (!words.skip("OFFSETS"))
        {
          cells.resize(n);
          for (auto &cell : cells)
            {
              cell.resize(words.integer());
              for (unsigned int &point : cell)
                point = words.integer();
            }
          return cells;
        }
      words.word(); // the type of the offsets
      std::vector<unsigned int> offsets(n), points(size);
      for (unsigned int &offset : offsets)
        offset = words.integer();
      AssertThrow(words.skip("CONNECTIVITY"),
                  ExcInput("there is no CONNECTIVITY after OFFSETS"));
      words.word();
      for (unsigned int &point : points)
        point = words.integer();
      for (unsigned int i = 1; i < n; ++i)
        {
          AssertThrow(offsets[i - 1] <= offsets[i] && offsets[i] <= size,
                      ExcInput("OFFSETS do not fit CONNECTIVITY"));
          cells.emplace_back(points.begin() + offsets[i - 1],
                             points.begin() + offsets[i]);
        }
      return cells;
    }

    /** Whether each cell is a line or polyline, and not points. */
    std::vector<bool>
    read_types(Words &words)
    {
      const unsigned int vertex = 1, poly_vertex = 2, line = 3, polyline = 4;
      std::vector<bool>  is_curve(words.integer());
      for (unsigned int i = 0; i < is_curve.size(); ++i)
        {
          const unsigned int type = words.integer();
          is_curve[i]             = type == line || type == polyline;
          AssertThrow(is_curve[i] || type == vertex || type == poly_vertex,
                      ExcInput("it has a cell of type " + std::to_string(type) +
                               ", but only points (1, 2), lines (3) and "
                               "polylines (4) are allowed"));
        }
      return is_curve;
    }
  } // namespace



  void
  read_vtk_lines(const std::string                                  &file,
                 std::vector<Tensor<1, 3>>                          &nodes,
                 std::vector<std::pair<unsigned int, unsigned int>> &lines)
  {
    Words words(file);
    AssertThrow(words.skip("DATASET"), ExcInput("there is no DATASET"));
    const bool is_grid = words.skip("UNSTRUCTURED_GRID");
    AssertThrow(is_grid || words.skip("POLYDATA"),
                ExcInput("its DATASET is neither UNSTRUCTURED_GRID nor "
                         "POLYDATA"));

    std::vector<bool> is_curve; // of poly data, all
    Cells             cells;
    while (!words.at_end())
      if (words.skip("POINTS"))
        {
          nodes.resize(words.integer());
          words.word(); // the type
          for (Tensor<1, 3> &node : nodes)
            for (unsigned int c = 0; c < 3; ++c)
              node[c] = words.real();
        }
      else if (words.skip(is_grid ? "CELLS" : "LINES"))
        cells = read_cells(words);
      else if (words.skip("CELL_TYPES"))
        is_curve = read_types(words);
      else if (words.skip("POINT_DATA") || words.skip("CELL_DATA"))
        break;
      else
        words.word();
    AssertThrow(!is_grid || is_curve.size() == cells.size(),
                ExcInput("there are not as many CELL_TYPES as CELLS"));
    for (unsigned int c = 0; c < cells.size(); ++c)
      if (!is_grid || is_curve[c])
        for (unsigned int i = 0; i + 1 < cells[c].size(); ++i)
          lines.emplace_back(cells[c][i], cells[c][i + 1]);

    for (const auto &[first, second] : lines)
      AssertThrow(std::max(first, second) < nodes.size(),
                  ExcInput("it has a line to the point " +
                           std::to_string(std::max(first, second)) +
                           ", but only " + std::to_string(nodes.size()) +
                           " points"));
  }
} // namespace Setae
