// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#include <setae/laws/section_integral.h>
#include <setae/laws/tabulated_disk_cylinder.h>

#include <algorithm>
#include <map>
#include <tuple>

namespace Setae
{
  namespace
  {
    /**
     * Extrapolate a table f(j, k), known for k <= j, a few rows beyond the
     * diagonal by the parabola through the three nodes next to it, in the
     * direction in which there are more of them.
     */
    void
    extrapolate(double *f, const unsigned int n)
    {
      constexpr unsigned int furthest = 4;

      const auto at = [f, n](const unsigned int j,
                             const unsigned int k) -> double & {
        return f[j * (n + 1) + k];
      };
      for (unsigned int j = 0; j <= n; ++j)
        for (unsigned int k = j + 1; k <= n; ++k)
          {
            const double x = std::min(k - j, furthest);
            double       f0, f1, f2;
            if (2 * k <= n)
              f0 = at(k, k), f1 = at(k + 1, k), f2 = at(k + 2, k);
            else if (j >= 2)
              f0 = at(j, j), f1 = at(j, j - 1), f2 = at(j, j - 2);
            else
              f0 = f1 = f2 = at(j, k - 1);
            at(j, k) =
              f0 + x * (f0 - f1) + .5 * x * (x + 1.) * (f0 - 2. * f1 + f2);
          }
    }
  } // namespace



  TabulatedDiskCylinder::TabulatedDiskCylinder(const PointPotential &potential,
                                               const SectionPair    &sections,
                                               const GapRange       &range,
                                               const LawAccuracy    &accuracy)
    : ContactLaw<TabulatedDiskCylinder>(sections, range)
    , held(H_regularization)
  {
    constexpr double       smallest = 1e-8, largest = 1e3;
    constexpr double       reference_tolerance = 5e-4;
    constexpr double       reference_spacing   = .85;
    constexpr unsigned int reference_n_angle   = 18;
    constexpr unsigned int n_depth = 14, n_lateral = 26;

    // The error decreases with the fourth power of the spacing.
    const double refinement =
      std::pow(reference_tolerance / accuracy.tolerance, .25);
    begin            = 2. * std::log(smallest * std::min(R1, R2));
    const double end = 2. * std::log(largest * std::max(R1, R2));
    n_distance = std::ceil((end - begin) / reference_spacing * refinement);
    n_angle    = std::max(6., std::ceil(reference_n_angle * refinement));
    spacing    = (end - begin) / n_distance;

    const unsigned int depth   = std::ceil(n_depth * refinement);
    const unsigned int lateral = std::ceil(n_lateral * refinement);
    for (const InversePower &power : potential)
      {
        // A table knows no prefactor: several laws of a scene, or the search
        // for the prefactors of one, ask for the same one.
        using Key = std::tuple<unsigned int, double, double, double>;
        static std::map<Key, SplineTable> tables;
        const Key key(power.exponent, R1, R2, accuracy.tolerance);
        if (tables.count(key) == 0)
          tables.emplace(key,
                         SplineTable({{n_distance, n_angle, n_angle}},
                                     tabulate(power.exponent, depth, lateral)));
        terms.push_back({{ContactPowers({power}, sections), H_regularization},
                         tables.at(key)});
      }
  }



  std::vector<double>
  TabulatedDiskCylinder::tabulate(const unsigned int exponent,
                                  const unsigned int n_depth,
                                  const unsigned int n_lateral) const
  {
    const SectionIntegral integral(exponent, R1, R2, n_depth, n_lateral);
    const ContactPowers   powers({{exponent, 1.}}, {R1, R2, 1., 1.});

    const unsigned int  n_plane = (n_angle + 1) * (n_angle + 1);
    std::vector<double> values((n_distance + 1) * n_plane);
    for (unsigned int i = 0; i <= n_distance; ++i)
      {
        const double s = std::exp(begin + i * spacing), R = R1 * R1;
        const double H = std::sqrt(s), M = std::log1p(R / s);
        double      *plane = &values[i * n_plane];

        // b^2 = a^2 exp(-y M), and the same for Q^2
        std::vector<double> square(n_angle + 1);
        for (unsigned int j = 0; j < n_angle; ++j)
          square[j] = R + (R + s) * std::expm1(-M * j / n_angle);
        for (unsigned int j = 0; j <= n_angle; ++j)
          for (unsigned int k = 0; k <= j; ++k)
            {
              const double W = square[k], C = square[j] / R;
              plane[j * (n_angle + 1) + k] = std::log(
                integral(DiskContact<double>{H, W, C}) /
                (powers.value(H) *
                 OrientedDiskCylinder::orientation_value(R1, R2, H, W, C)));
            }
        extrapolate(plane, n_angle);
      }
    return values;
  }



  ContactDerivatives
  TabulatedDiskCylinder::derivatives(const DiskContact<double> &contact) const
  {
    const GapDerivatives h = held.derivatives(contact.H);
    const double         H = h.value, W = contact.W, C = contact.C;
    const double         s = H * H, R = R1 * R1;

    // Derivatives in eta = ln s, in which a^2 has s / a^2, and W and C.
    const double a = 1. / (R + s), b = 1. / (R * C + s), q = 1. / (W + s);
    const double M = std::log1p(R / s), M_e = -R * a, M_ee = R * a * s * a;
    const double r = 1. / M, n = n_angle;

    const double y   = r * std::log1p(R * (1. - C) * b);
    const double y_e = r * (-s * R * (1. - C) * a * b - y * M_e);
    const double y_ee =
      r * (s * R * (a * a - C * b * b) - 2. * y_e * M_e - y * M_ee);
    const double y_C  = -r * R * b;
    const double y_eC = r * (R * s * b * b - y_C * M_e);
    const double y_CC = r * R * R * b * b;

    const double z   = r * std::log1p((R - W) * q);
    const double z_e = r * (-s * (R - W) * a * q - z * M_e);
    const double z_ee =
      r * (s * (R * a * a - W * q * q) - 2. * z_e * M_e - z * M_ee);
    const double z_W  = -r * q;
    const double z_eW = r * (s * q * q - z_W * M_e);
    const double z_WW = r * q * q;

    const double   eta = std::log(s);
    GapDerivatives x   = {(eta - begin) / spacing, 1. / spacing, 0.};
    const bool low     = x.value<1., high = x.value> n_distance - 1.;
    if (low || high)
      {
        const GapDerivatives at_end =
          Held(1.).derivatives(low ? x.value : n_distance - x.value);
        x = {low ? at_end.value : n_distance - at_end.value,
             at_end.first / spacing,
             (low ? 1. : -1.) * at_end.second / (spacing * spacing)};
      }
    const double e_H = 2. / H, e_HH = -2. / s;

    ContactDerivatives sum;
    for (const Term &term : terms)
      {
        const GapDerivatives    p = term.powers.derivatives(contact.H);
        const SplineDerivatives t =
          exponential(term.correction.derivatives(x.value, n * y, n * z));
        const double t_x = t.first[0], t_y = n * t.first[1],
                     t_z  = n * t.first[2];
        const double t_xy = n * t.xy, t_xz = n * t.xz, t_yy = n * n * t.yy,
                     t_yz = n * n * t.yz, t_zz = n * n * t.zz;

        const double e = t_x * x.first + t_y * y_e + t_z * z_e;
        const double ee =
          t.xx * x.first * x.first + t_x * x.second + t_yy * y_e * y_e +
          t_y * y_ee + t_zz * z_e * z_e + t_z * z_ee +
          2. * (x.first * (t_xy * y_e + t_xz * z_e) + t_yz * y_e * z_e);
        const double e_by_y = t_xy * x.first + t_yy * y_e + t_yz * z_e;
        const double e_by_z = t_xz * x.first + t_yz * y_e + t_zz * z_e;

        ContactDerivatives f;
        f.value = t.value;
        f.H     = e * e_H;
        f.W     = t_z * z_W;
        f.C     = t_y * y_C;
        f.HH    = ee * e_H * e_H + e * e_HH;
        f.HW    = (e_by_z * z_W + t_z * z_eW) * e_H;
        f.HC    = (e_by_y * y_C + t_y * y_eC) * e_H;
        f.WW    = t_zz * z_W * z_W + t_z * z_WW;
        f.WC    = t_yz * z_W * y_C;
        f.CC    = t_yy * y_C * y_C + t_y * y_CC;
        sum += OrientedDiskCylinder::product(p, h, f);
      }
    return sum.times(OrientedDiskCylinder::product(
      {1., 0., 0.}, h, OrientedDiskCylinder::orientation(R1, R2, H, W, C)));
  }
} // namespace Setae
