// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#include <deal.II/base/exceptions.h>
#include <deal.II/base/utilities.h>

#include <zlib.h>

#include <setae/output/vtu.h>

#include <cstdint>
#include <cstring>
#include <limits>
#include <sstream>

namespace Setae
{
  namespace
  {
    template <typename Number>
    std::string
    base64(const std::vector<Number> &numbers)
    {
      std::vector<unsigned char> bytes(numbers.size() * sizeof(Number));
      if (!bytes.empty())
        std::memcpy(bytes.data(), numbers.data(), bytes.size());
      return dealii::Utilities::encode_base64(bytes);
    }

    /** One compressed block after its sizes; no block if there are no numbers.
     */
    template <typename Number>
    std::string
    encoded(const std::vector<Number> &numbers)
    {
      const uLong n_bytes = numbers.size() * sizeof(Number);
      if (n_bytes == 0)
        return base64(std::vector<std::uint64_t>(3, 0));

      uLongf                     n_compressed = compressBound(n_bytes);
      std::vector<unsigned char> block(n_compressed);
      // The best compression takes 8 times as long for a sixth fewer bytes.
      const int status =
        compress2(block.data(),
                  &n_compressed,
                  reinterpret_cast<const Bytef *>(numbers.data()),
                  n_bytes,
                  Z_BEST_SPEED);
      AssertThrow(status == Z_OK, dealii::ExcInternalError());
      block.resize(n_compressed);
      return base64(
               std::vector<std::uint64_t>{1, n_bytes, n_bytes, n_compressed}) +
             base64(block);
    }

    template <typename Number>
    void
    write_array(std::ostream              &out,
                const std::string         &type,
                const std::string         &name,
                const unsigned int         n_components,
                const std::vector<Number> &numbers)
    {
      out << "<DataArray type=\"" << type << "\" Name=\"" << name
          << "\" NumberOfComponents=\"" << n_components
          << "\" format=\"binary\">\n"
          << encoded(numbers) << "\n</DataArray>\n";
    }

    void
    write_header(std::ostream      &out,
                 const std::string &attributes,
                 const std::string &comment)
    {
      out << "<?xml version=\"1.0\"?>\n<!-- " << comment << " -->\n<VTKFile "
          << attributes << " byte_order=\""
          << (__BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__ ? "LittleEndian" :
                                                          "BigEndian")
          << "\">\n";
    }

    void
    write_cells(std::ostream      &out,
                const unsigned int n_points,
                const unsigned int n_points_of_chain)
    {
      constexpr std::uint8_t    vertex = 1, line = 3;
      std::vector<std::int64_t> connectivity, offsets;
      for (std::int64_t i = 0; i < n_points; ++i)
        {
          if (n_points_of_chain == 1)
            connectivity.push_back(i);
          else if ((i + 1) % n_points_of_chain != 0)
            connectivity.insert(connectivity.end(), {i, i + 1});
          else
            continue;
          offsets.push_back(connectivity.size());
        }
      const std::vector<std::uint8_t> types(offsets.size(),
                                            n_points_of_chain == 1 ? vertex :
                                                                     line);
      out << "<Cells>\n";
      write_array(out, "Int64", "connectivity", 1, connectivity);
      write_array(out, "Int64", "offsets", 1, offsets);
      write_array(out, "UInt8", "types", 1, types);
      out << "</Cells>\n";
    }
  } // namespace



  unsigned int
  PointFields::n_values_of_point() const
  {
    unsigned int result = 3;
    for (const auto &field : fields)
      result += field.second;
    return result;
  }



  std::string
  vtu(const PointFields &points, const std::string &comment)
  {
    const unsigned int n_values = points.n_values_of_point();
    const unsigned int n_points = points.values.size() / n_values;
    const unsigned int n_lines_of_chain =
      std::max(points.n_points_of_chain - 1, 1u);
    const unsigned int n_cells =
      n_points / points.n_points_of_chain * n_lines_of_chain;

    const auto columns = [&](const unsigned int first, const unsigned int n) {
      std::vector<double> result;
      result.reserve(static_cast<std::size_t>(n_points) * n);
      for (unsigned int p = 0; p < n_points; ++p)
        for (unsigned int c = first; c < first + n; ++c)
          result.push_back(
            points.values[static_cast<std::size_t>(p) * n_values + c]);
      return result;
    };

    std::ostringstream out;
    write_header(out,
                 "type=\"UnstructuredGrid\" version=\"1.0\" "
                 "header_type=\"UInt64\" compressor=\"vtkZLibDataCompressor\"",
                 comment);
    out << "<UnstructuredGrid>\n<Piece NumberOfPoints=\"" << n_points
        << "\" NumberOfCells=\"" << n_cells << "\">\n<Points>\n";
    write_array(out, "Float64", "Points", 3, columns(0, 3));
    out << "</Points>\n";
    write_cells(out, n_points, points.n_points_of_chain);
    out << "<PointData>\n";
    unsigned int first = 3;
    for (const auto &[name, n_components] : points.fields)
      {
        write_array(
          out, "Float64", name, n_components, columns(first, n_components));
        first += n_components;
      }
    out << "</PointData>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
    return out.str();
  }



  std::string
  pvd(const std::vector<std::pair<double, std::string>> &files,
      const std::string                                 &comment)
  {
    std::ostringstream out;
    out.precision(std::numeric_limits<double>::digits10);
    write_header(out, "type=\"Collection\" version=\"0.1\"", comment);
    out << "<Collection>\n";
    for (const auto &[time, file] : files)
      out << "<DataSet timestep=\"" << time << R"(" group="" part="0" file=")"
          << file << "\"/>\n";
    out << "</Collection>\n</VTKFile>\n";
    return out.str();
  }
} // namespace Setae
