// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

// Step 3: from six integrals to one. Two straight fibers cross at an angle.
// Their energy and force are computed by the reduced laws, one integral along a
// fiber, and compared with the exact ones. The introduction is in doc/intro.md,
// the output is discussed in doc/results.md.

#include <deal.II/base/table_handler.h>

#include <setae/laws/all.h>
#include <setae/verification/cylinders.h>

#include <chrono>
#include <cmath>
#include <iomanip>
#include <iostream>
#include <sstream>

namespace Step3
{
  using namespace Setae;

  // Two fibers of radius one attract each other with r^-6. Everything scales
  // with the radius, so the gap is the only length that matters.
  const SectionPair  sections = {1., 1., 1., 1.};
  const InversePower van_der_waals{6, -1.};



  // The sections of the source, seen from the target. The source runs along s,
  // the target crosses it below s = 0. At the section s the closest point of
  // the target is at the distance sqrt(d^2 + s^2 sin^2(alpha)); the section
  // leans over by the component of its tangent along the connecting vector.
  struct Pose
  {
    double gap, cosine, tilt;
    double gap_d, tilt_d; // derivatives with respect to the smallest distance d
  };

  Pose
  pose(const double gap, const double angle, const double s)
  {
    const double contact = sections.radius_1 + sections.radius_2;
    const double d       = contact + gap;
    const double lateral = s * std::sin(angle);
    const double r       = std::hypot(d, lateral);

    // r - contact, without the difference of two large numbers.
    const double local_gap =
      (gap * (contact + d) + lateral * lateral) / (r + contact);
    const double tilt = std::sin(angle) * lateral / r;
    return {local_gap, std::cos(angle), tilt, d / r, -tilt * d / (r * r)};
  }



  // The energy of a section and its derivative with respect to d, for laws that
  // know of the tilt and for laws that do not.
  template <typename Law>
  GapDerivatives
  of_section(const Law &law, const Pose &p)
  {
    if constexpr (Law::depends_on == Invariants::gap_angle_tilt)
      {
        const auto f = law(p.gap, p.cosine, p.tilt);
        return {f.value, f.g * p.gap_d + f.t * p.tilt_d, 0.};
      }
    else
      {
        const auto f = law(p.gap, p.cosine);
        return {f.value, f.g * p.gap_d, 0.};
      }
  }



  struct Result
  {
    double energy, force, microseconds;
  };

  // The one integral that is left. The integrand is a peak as wide as sqrt(g
  // d); with s = sqrt(g d) sinh(u) / sin(alpha), equal steps in u resolve the
  // peak and the long tail alike and converge exponentially.
  template <typename Law>
  Result
  along_source(const Law &law, const double gap, const double angle)
  {
    constexpr double step = .1, end = 20.;
    const double     width = std::sqrt(gap * (2. + gap)) / std::sin(angle);

    const auto   start = std::chrono::steady_clock::now();
    Result       sum   = {0., 0., 0.};
    unsigned int n     = 0;
    for (double u = -end; u <= end; u += step, ++n)
      {
        const double         ds = step * width * std::cosh(u);
        const GapDerivatives f =
          of_section(law, pose(gap, angle, width * std::sinh(u)));
        sum.energy += ds * f.value;
        sum.force -= ds * f.first;
      }
    const std::chrono::duration<double, std::micro> time =
      std::chrono::steady_clock::now() - start;
    sum.microseconds = time.count() / n;
    return sum;
  }



  std::string
  percent(const double value, const double exact)
  {
    std::ostringstream text;
    text << std::fixed << std::setprecision(3) << 100. * (value / exact - 1.);
    return text.str();
  }



  // A line of the table for each law; returns the error of the force.
  template <typename Law>
  double
  compare(const double gap, const double degrees, dealii::TableHandler &table)
  {
    const double angle = degrees * M_PI / 180.;
    const auto   exact =
      References::crossing_cylinders(van_der_waals, sections, gap, angle);
    const Result result =
      along_source(make_law<Law>({van_der_waals}, sections, GapRange()),
                   gap,
                   angle);

    table.add_value("angle", degrees);
    table.add_value("g/R", gap);
    table.add_value("law", std::string(Law::name));
    table.add_value("error of energy [%]",
                    percent(result.energy, exact.energy.value));
    table.add_value("error of force [%]",
                    percent(result.force, exact.force.value));
    table.add_value("us per section", result.microseconds);
    return result.force / exact.force.value - 1.;
  }
} // namespace Step3



int
main()
{
  using namespace Step3;

  dealii::TableHandler table;
  bool                 is_right = true;
  for (const double degrees : {10., 90.})
    for (const double gap : {1e-4, 1e-2, 1.})
      {
        compare<DiskCylinder>(gap, degrees, table);
        compare<OrientedDiskCylinder>(gap, degrees, table);
        compare<SectionQuadrature>(gap, degrees, table);
        const double error =
          compare<TabulatedDiskCylinder>(gap, degrees, table);
        is_right = is_right && std::abs(error) < 1e-3;
      }
  table.set_precision("angle", 0);
  table.set_scientific("g/R", true);
  table.set_precision("g/R", 0);
  table.set_precision("us per section", 2);
  table.write_text(std::cout, dealii::TableHandler::org_mode_table);

  if (!is_right)
    std::cout << "The tabulated law is not right to 0.1%.\n";
  return is_right ? 0 : 1;
}
