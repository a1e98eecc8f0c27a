// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#include <setae/base/derivative.h>
#include <setae/base/exceptions.h>
#include <setae/fibers/centerline.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace Setae
{
  using namespace dealii;

  namespace
  {
    /** The angle between two vectors in degrees, also a small one. */
    double
    degrees_between(const Tensor<1, 3> &a, const Tensor<1, 3> &b)
    {
      return std::atan2(cross_product_3d(a, b).norm(), a * b) * 180. / M_PI;
    }

    std::string
    as_text(const Tensor<1, 3> &place)
    {
      std::ostringstream text;
      text << '(' << place[0] << ", " << place[1] << ", " << place[2] << ')';
      return text.str();
    }

    template <typename... Parts>
    std::string
    sentence(const Parts &...parts)
    {
      std::ostringstream text;
      (text << ... << parts);
      return text.str();
    }

    /** The formula of a centerline with what its messages need. */
    struct Formula
    {
      Formula(const FiberParameters &parameters,
              const Constants       &constants,
              const Constants       &copy)
        : parameters(parameters)
        , path("fibers/" + parameters.name + "/centerline")
        , curve(path, parameters.centerline, "s", with_copy(constants, copy))
        , spacing(parameters.length / parameters.n_cells)
      {
        // Sums of spacings might lie beyond the end.
        for (unsigned int i = 0; i <= parameters.n_cells; ++i)
          s.push_back(i == parameters.n_cells ?
                        parameters.length :
                        parameters.length * i / parameters.n_cells);
      }

      void
      require_curve(const bool condition, const std::string &allowed) const
      {
        AssertThrow(condition,
                    ExcParameter(path, parameters.centerline, allowed));
      }

      SidedDerivatives
      derivatives(const unsigned int i) const
      {
        return differentiate_within([this](const double x) { return curve(x); },
                                    s[i],
                                    0.,
                                    parameters.length,
                                    spacing);
      }

      const FiberParameters &parameters;
      const std::string      path;
      const VectorExpression curve;
      const double           spacing;
      std::vector<double>    s; ///< of the nodes
    };

    /** Differences of coordinates need digits that their size leaves. */
    void
    check_digits(const Formula &formula, const Centerline &line)
    {
      constexpr double largest = 1e-8;

      const double shortest = line.shortest_cell();
      formula.require_curve(
        shortest == 0. || line.rounding <= largest * shortest,
        sentence("nearer to the origin: coordinates of the size of those of ",
                 as_text(line.positions[0]),
                 " are rounded by ",
                 line.rounding,
                 ", more than ",
                 largest,
                 " of a cell of length ",
                 shortest));
    }

    /** The unit tangent at a node, which both sides agree on. */
    Tensor<1, 3>
    tangent_at(const Formula          &formula,
               const SidedDerivatives &derivatives,
               const double            s,
               const Tensor<1, 3>     &place,
               const double            chord,
               const double            rounding)
    {
      const Tensor<1, 3> mean = derivatives.mean();
      const double       size =
        std::min(derivatives.left.norm(), derivatives.right.norm());
      formula.require_curve(size * formula.spacing > 1e-6 * chord &&
                              size > 10. * derivatives.error,
                            sentence("a curve with a tangent at every s, but "
                                     "has none at s = ",
                                     s));
      const double angle = degrees_between(derivatives.left, derivatives.right);
      formula.require_curve(angle * M_PI / 180. <=
                              1e-6 + 2. * derivatives.error / size,
                            sentence("a curve without kinks, but turns by ",
                                     angle,
                                     " degrees at s = ",
                                     s,
                                     ", ",
                                     as_text(place)));
      formula.require_curve(
        derivatives.error <= size * std::max(1e-8, 100. * rounding / chord),
        sentence("a curve with a tangent at every s, but at s = ",
                 s,
                 " its derivative is known up to ",
                 derivatives.error / size,
                 " of its size only"));
      return mean / mean.norm();
    }

    /** A curve that comes back to its start becomes a ring. */
    void
    close(const Formula            &formula,
          const SidedDerivatives   &at_start,
          const SidedDerivatives   &at_end,
          Centerline               &line,
          std::vector<std::string> &notices)
    {
      const double error = std::max(at_start.error, at_end.error);
      const double size  = at_start.right.norm();
      const double angle = degrees_between(at_end.left, at_start.right);
      const auto  &start = line.positions.front();
      formula.require_curve(
        angle * M_PI / 180. <= 1e-6 + 2. * error / size,
        sentence("an open curve or a ring without a kink, but comes back to "
                 "its start ",
                 as_text(start),
                 " turned by ",
                 angle,
                 " degrees"));
      formula.require_curve(line.positions.size() > 3,
                            "a ring of at least 3 cells");
      const Tensor<1, 3> tangent = line.tangents.front() + line.tangents.back();
      line.positions.pop_back();
      line.tangents.pop_back();
      line.tangents.front() = tangent / tangent.norm();
      line.closed           = true;
      notices.push_back("The fiber '" + formula.parameters.name +
                        "' comes back to its start " + as_text(start) +
                        " and is a ring.");
    }
  } // namespace



  Centerline
  centerline_of_formula(const FiberParameters    &parameters,
                        const Constants          &constants,
                        const Constants          &copy,
                        std::vector<std::string> &notices)
  {
    const Formula formula(parameters, constants, copy);
    Centerline    line;
    line.copy       = copy;
    line.parameters = formula.s;
    double largest  = 0.;
    for (const double s : formula.s)
      {
        line.positions.push_back(formula.curve(s));
        largest = std::max(largest, line.positions.back().norm());
      }
    line.rounding = largest * std::numeric_limits<double>::epsilon();
    check_digits(formula, line);

    const auto                   &x = line.positions;
    std::vector<SidedDerivatives> derivatives;
    double                        extent = 0.;
    for (unsigned int i = 0; i < x.size(); ++i)
      {
        const double before = i > 0 ? (x[i] - x[i - 1]).norm() : 0.;
        const double after  = i + 1 < x.size() ? (x[i + 1] - x[i]).norm() : 0.;
        extent              = std::max(extent, (x[i] - x[0]).norm());
        derivatives.push_back(formula.derivatives(i));
        line.tangents.push_back(tangent_at(formula,
                                           derivatives.back(),
                                           formula.s[i],
                                           x[i],
                                           std::max(before, after),
                                           line.rounding));
      }

    if ((x.back() - x.front()).norm() <= 4. * line.rounding + 1e-10 * extent)
      close(formula, derivatives.front(), derivatives.back(), line, notices);
    if (line.is_straight())
      line.straighten();
    return line;
  }
} // namespace Setae
