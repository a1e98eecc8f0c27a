// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

// Two parallel cylinders of finite length slide along each other: energy and
// axial force against the exact ones, with a target that ends (EndFraction,
// FlatEnd) and with the closest point clamped to its end (SBIP). Both use the
// exact energy per length of infinite cylinders, so that the difference is due
// to the ends. Then they are drawn apart, beyond the flush position.

#include <deal.II/base/quadrature_lib.h>

#include <setae/laws/disk_cylinder.h>
#include <setae/laws/end_fraction.h>
#include <setae/laws/flat_end.h>
#include <setae/laws/tabulated_disk_cylinder.h>
#include <setae/verification/cylinders.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

using namespace Setae;

namespace
{
  /**
   * All pairs of lines of two parallel cylinders: their distances and how many
   * there are, times the energy per length of a pair of infinite lines.
   */
  class Lines
  {
  public:
    /** Sections of radius 1 and @p R at the distance 1 + R + gap. */
    Lines(const unsigned int m, const double R, const double gap)
      : m(m)
      , quarter(.5 * std::sqrt(M_PI) * std::tgamma((m - 1.) / 2.) /
                std::tgamma(m / 2.))
    {
      // A line of the second section at the distance t from the center of the
      // first one has there the arc 2 angle(p) of lines at the distance p
      // (ISSIP eq. A6). Both distances are logarithmic from the gap on.
      const dealii::QGauss<1> rule(40);
      const double            d          = 1. + R + gap;
      const auto              half_angle = [](const double r,
                                 const double radius,
                                 const double distance,
                                 const double depth) {
        const double cosine =
          1. - depth * (2. * radius - depth) / (2. * r * distance);
        return std::acos(std::min(1., std::max(-1., cosine)));
      };
      for (unsigned int i = 0; i < rule.size(); ++i)
        {
          const double y    = std::log1p(2. * R / gap) * rule.point(i)[0];
          const double near = gap * std::exp(y), depth = gap * std::expm1(y);
          const double t     = 1. + near;
          const double outer = std::log1p(2. * R / gap) * rule.weight(i) *
                               near * 2. * t * half_angle(t, R, d, depth);
          for (unsigned int j = 0; j < rule.size(); ++j)
            {
              const double z     = std::log1p(2. / near) * rule.point(j)[0];
              const double rho   = near * std::exp(z);
              const double inner = std::log1p(2. / near) * rule.weight(j) *
                                   rho * 2. * rho *
                                   half_angle(rho, 1., t, near * std::expm1(z));
              lines.push_back(
                {rho, outer * inner * std::pow(rho, 1. - m) * 2. * quarter});
            }
        }
      for (const Line &line : lines)
        energy_per_length += line.energy;
    }

    /** The exact fraction of EndFraction. */
    double
    fraction(const double z) const
    {
      double sum = 0.;
      for (const Line &line : lines)
        sum += line.energy * of_line(z / line.rho);
      return sum / energy_per_length;
    }

    double energy_per_length = 0.;

  private:
    struct Line
    {
      double rho, energy;
    };

    double
    of_line(const double u) const
    {
      const double c = 1. / std::sqrt(1. + u * u), s = u * c;
      unsigned int n    = m % 2;
      double       part = n == 0 ? std::atan(u) : s, power = n == 0 ? c : c * c;
      for (n += 2; n <= m - 2; n += 2, power *= c * c)
        part = (power * s + (n - 1.) * part) / n;
      return .5 + part / (2. * quarter);
    }

    unsigned int      m;
    double            quarter;
    std::vector<Line> lines;
  };



  /** The energy of a section beside or beyond the end, per length. */
  class End
  {
  public:
    End(const unsigned int m,
        const SectionPair &sections,
        const double       gap,
        const double       energy_per_length)
      : gap(gap)
      , square((gap + sections.radius_1 + sections.radius_2) *
               (gap + sections.radius_1 + sections.radius_2))
      , energy_per_length(energy_per_length)
      , fraction(m, sections, {})
      , flat_end({m, 1.}, sections, {})
    {}

    double
    energy(const double z) const
    {
      const auto front =
        flat_end.front(FlatEnd::Pose<double>{square, 0., 1., z},
                       flat_end.softened(gap));
      return front.energy + front.side_share * energy_per_length *
                              fraction.value(gap, gap, 1., 0., z);
    }

  private:
    double      gap, square, energy_per_length;
    EndFraction fraction;
    FlatEnd     flat_end;
  };



  /**
   * Largest errors over all positions of two cylinders of length @p length: of
   * the energy relative to that of the whole length and of the axial force
   * relative to its size far from all ends, the energy per length.
   */
  struct Errors
  {
    double energy = 0., force = 0.;
  };

  template <typename Exact, typename Model>
  Errors
  compare(const Exact &exact, const Model &model, const double length)
  {
    // The fraction f(z) at the axial distance z inside an end gives, with
    // F' = f, the energy and the force of a source from 0 to length before a
    // target from s to s + length.
    constexpr unsigned int n    = 800;
    const double           step = 4. * length / n;
    std::vector<double>    f(n + 1), g(n + 1), F(n + 1), G(n + 1);
    for (unsigned int i = 0; i <= n; ++i)
      {
        const double z = -2. * length + i * step;
        f[i] = exact(z), g[i] = model(z);
        if (i > 0)
          {
            F[i] = F[i - 1] + .5 * step * (f[i] + f[i - 1]);
            G[i] = G[i - 1] + .5 * step * (g[i] + g[i - 1]);
          }
      }
    const unsigned int one = n / 4, zero = n / 2;
    Errors             result;
    for (unsigned int s = 0; s <= one; ++s)
      {
        // Inside by z - s from the left end and by s + length - z from the
        // right
        const auto energy = [&](const std::vector<double> &F) {
          return (F[zero + one - s] - F[zero - s]) +
                 (F[zero + one + s] - F[zero + s]) - length;
        };
        const auto force = [&](const std::vector<double> &f) {
          return (f[zero + one - s] - f[zero - s]) -
                 (f[zero + one + s] - f[zero + s]);
        };
        result.energy =
          std::max(result.energy, std::abs(energy(G) - energy(F)) / length);
        result.force = std::max(result.force, std::abs(force(g) - force(f)));
      }
    return result;
  }



  /** The same of cylinders whose ends are apart, relative to the exact ones. */
  Errors
  compare_apart(const unsigned int m,
                const SectionPair &sections,
                const double       gap,
                const End         &end,
                const double       length)
  {
    // Of a target from 0 to length
    const auto section = [&](const double z) {
      return end.energy(z) - end.energy(z - length);
    };
    const dealii::QGauss<1> rule(60);
    Errors                  result;
    for (const double apart : {0., .03, .1, .3, 1., 2.})
      {
        const auto exact = References::finite_parallel_cylinders(
          {m, 1.}, sections, gap, {length, length, length + apart});
        // Points logarithmic from the gap on
        const double range  = std::log1p(length / gap);
        double       energy = 0.;
        for (unsigned int i = 0; i < rule.size(); ++i)
          {
            const double s = gap * std::expm1(range * rule.point(i)[0]);
            energy += range * rule.weight(i) * (gap + s) * section(-apart - s);
          }
        const double force = section(-apart) - section(-apart - length);
        result.energy =
          std::max(result.energy, std::abs(energy / exact.energy.value - 1.));
        result.force =
          std::max(result.force, std::abs(force / exact.thrust.value - 1.));
      }
    return result;
  }
} // namespace

int
main()
{
  constexpr double length = 10.;
  std::printf("largest error in %% of the energy of the whole length (10 R1) / "
              "of the axial force;\napart by up to 2 R1: relative to the exact "
              "ones\n%4s%8s%10s%22s%22s%22s%22s\n",
              "m",
              "R2/R1",
              "g/R1",
              "finite",
              "clamped",
              "clamped disk-cylinder",
              "finite, apart");
  bool is_better = true;
  for (const unsigned int m : {6, 12})
    for (const double R : {1., .3, 3.})
      for (const double gap : {1e-3, .01, .05, .3, 1., 3.})
        {
          const Lines       lines(m, R, gap);
          const SectionPair sections = {1., R, 1., 1.};
          const End         end(m, sections, gap, lines.energy_per_length);
          const Lines      *exact = &lines;

          // Clamped: the law at the distance from the last point, in the
          // table's exact form for parallel fibers and in that of the paper.
          const TabulatedDiskCylinder table({{m, 1.}}, sections, {}, {});
          const DiskCylinder          paper({{m, 1.}}, sections, {});
          const auto                  gap_to_end = [&](const double z) {
            return z >= 0. ? gap : std::hypot(1. + R + gap, z) - 1. - R;
          };
          const auto of_exact = [&](const double z) {
            return exact->fraction(z);
          };
          const Errors finite = compare(
            of_exact,
            [&](const double z) {
              return end.energy(z) / lines.energy_per_length;
            },
            length);
          const Errors apart   = compare_apart(m, sections, gap, end, length);
          const Errors clamped = compare(
            of_exact,
            [&](const double z) {
              return table(gap_to_end(z), 1., 0.).value /
                     lines.energy_per_length;
            },
            length);
          const Errors of_paper = compare(
            of_exact,
            [&](const double z) {
              return paper(gap_to_end(z), 1.).value / lines.energy_per_length;
            },
            length);
          std::printf(
            "%4u%8g%10g%14.3f/%7.3f%14.3f/%7.3f%14.3f/%7.3f%14.1f/%7.1f\n",
            m,
            R,
            gap,
            100. * finite.energy,
            100. * finite.force,
            100. * clamped.energy,
            100. * clamped.force,
            100. * of_paper.energy,
            100. * of_paper.force,
            100. * apart.energy,
            100. * apart.force);
          is_better = is_better && finite.energy < clamped.energy &&
                      finite.force < clamped.force;
        }
  return is_better ? 0 : 1;
}
