// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_laws_section_integral_h
#define setae_laws_section_integral_h

#include <deal.II/base/quadrature_lib.h>

#include <setae/laws/disk_contact.h>
#include <setae/laws/point_cylinder.h>

namespace Setae
{
  /**
   * The potential of a cylinder (PointCylinder) integrated over a disk by
   * quadrature, exact at every gap and angle in the limit of many points.
   *
   * The disk is cut into chords that begin at its edge next to the cylinder and
   * run along its steepest line. A chord at the lateral coordinate
   * @f$v=R_1\sin\chi@f$ is chosen by the midpoint rule in @f$\vartheta@f$ with
   * @f$\tan\chi=\beta\tan\vartheta@f$, which converges spectrally; @f$\beta
   * R_1@f$ is the width over which the integrand decays. Along a chord whose gap
   * grows as @f$h_0(1+s/\ell)@f$ the substitution
   * @f$(1+s/\ell)^{4-m}=1-t(\ldots)@f$ makes @f$h^{3-m}\,ds@f$ constant, and
   * Gauss' rule does the rest. Where the disk leans over so far that a chord
   * comes next to the cylinder in its interior, it has two such parts.
   */
  class SectionIntegral
  {
  public:
    /**
     * @param exponent m, at least 6.
     * @param n_depth Gauss points along each chord.
     * @param n_lateral The number of chords.
     */
    SectionIntegral(const unsigned int exponent,
                    const double       radius_1,
                    const double       radius_2,
                    const unsigned int n_depth,
                    const unsigned int n_lateral)
      : m(exponent)
      , R1(radius_1)
      , R2(radius_2)
      , potential(exponent, radius_2)
      , depth(n_depth)
      , n_lateral(n_lateral)
    {}

    /** The integral of @f$r^{-m}@f$ over the disk and the cylinder. */
    template <typename Number>
    Number
    operator()(const DiskContact<Number> &contact) const
    {
      using std::sqrt;

      // With t1 = c t2 + P1 e + P2 f and f normal to e and t2, the disk is
      // spanned by the inward normal (sin(t1, e), -shift f) at its edge and by
      // the tangent (0, -turn f) there. The squares of P1 and P2 are kept from
      // zero, where their roots have no derivative and f no meaning; what that
      // changes cancels in first order.
      constexpr double tiny = 1e-6, tiniest = 1e-24;
      const Number     slope_square = contact.W / (R1 * R1);
      const Number     P1_square    = 1. - slope_square + tiny;
      const Number     P2_square =
        slope_square - contact.C + tiny * slope_square + tiniest;
      const Number &H     = contact.H;
      const Number  Q     = sqrt(contact.W + H * H);
      const Number  slope = sqrt(slope_square + tiniest);
      const Number  width = sqrt(contact.C + P2_square);
      const Number  shift = sqrt(P1_square * P2_square) / width;
      const Number  turn  = sqrt(contact.C + tiny * P2_square) / width;
      const Number  beta  = lateral_width(contact, Q, slope, width, turn);

      Number sum = 0.;
      for (unsigned int i = 0; i < n_lateral; ++i)
        {
          const double theta     = M_PI * ((i + .5) / n_lateral - .5);
          const double tan_theta = std::tan(theta);
          const Number tan_chi   = beta * tan_theta;
          const Number cos_chi   = 1. / sqrt(1. + tan_chi * tan_chi);
          const Number sin_chi   = tan_chi * cos_chi;
          const Number d_chi     = (1. + tan_theta * tan_theta) *
                               (M_PI / n_lateral) * beta * cos_chi * cos_chi;

          // The chord begins at R1 (-cos(chi), sin(chi)) and the disk in
          // (R2 + H + Q, -R1^2 shift width / Q).
          Chord<Number> chord;
          chord.length = 2. * R1 * cos_chi;
          chord.gap    = H + H * H / (Q + R1 * slope) +
                      R1 * slope * sin_chi * sin_chi / (1. + cos_chi);
          chord.side =
            shift * (R1 * cos_chi - R1 * R1 * width / Q) + R1 * sin_chi * turn;
          chord.gap_s  = slope;
          chord.side_s = -shift;
          sum += R1 * cos_chi * d_chi * over(chord);
        }
      return sum;
    }

  private:
    /**
     * Half the width of the integrand, up to a factor of R1: along the curved
     * edge or, where the disk is flat before the cylinder, along the line of
     * contact.
     */
    template <typename Number>
    Number
    lateral_width(const DiskContact<Number> &contact,
                  const Number              &Q,
                  const Number              &slope,
                  const Number              &width,
                  const Number              &turn) const
    {
      using std::sqrt;
      constexpr double tiny   = 1e-20;
      const Number    &H      = contact.H;
      const Number     edge   = slope / R1 + turn * turn / R2 + tiny;
      const Number     steep  = R1 * R1 / 16. * slope * slope * slope / (H * H);
      const Number     side_2 = 1. - contact.C / (width * width);
      const Number     flat   = H / Q * (H / Q) * H;
      const Number     B_2 =
        (2. * H / (edge * (m - 4.)) +
         flat * flat * side_2 / (contact.C + steep * steep + tiny)) /
        (R1 * R1);
      return sqrt(B_2 / (1. + B_2));
    }

    /**
     * The line (R2 + gap, side) + s (gap_s, side_s) in the plane normal to the
     * axis of the cylinder.
     */
    template <typename Number>
    struct Chord
    {
      Number length, gap, side, gap_s, side_s;
    };

    template <typename Number>
    Number
    over(const Chord<Number> &chord) const
    {
      // s / square is where the line is next to the axis.
      const Number square =
        chord.gap_s * chord.gap_s + chord.side_s * chord.side_s;
      const Number s =
        -((R2 + chord.gap) * chord.gap_s + chord.side * chord.side_s);
      if (!(s > 0.))
        return upwards(chord, Number(0.), chord.length, 1.);
      if (s >= square * chord.length)
        return upwards(chord, chord.length, chord.length, -1.);
      const Number begin = s / square;
      return upwards(chord, begin, Number(chord.length - begin), 1.) +
             upwards(chord, begin, begin, -1.);
    }

    /** The part of a chord from @p begin in the direction @p sign. */
    template <typename Number>
    Number
    upwards(const Chord<Number> &chord,
            const Number        &begin,
            const Number        &length,
            const double         sign) const
    {
      using std::pow;
      using std::sqrt;
      constexpr double tiny = 1e-30;

      const Number gap  = chord.gap + begin * chord.gap_s;
      const Number side = chord.side + begin * chord.side_s;
      const Number x    = sqrt((R2 + gap) * (R2 + gap) + side * side);
      const Number h    = (gap * (2. * R2 + gap) + side * side) / (x + R2);
      const Number h_s =
        sign * ((R2 + gap) * chord.gap_s + side * chord.side_s) / x;
      const Number h_ss =
        (chord.gap_s * chord.gap_s + chord.side_s * chord.side_s - h_s * h_s) /
        x;
      const Number l = 2. * h / (h_s + sqrt(h_s * h_s + 2. * h * h_ss + tiny));

      const unsigned int n = m - 4;
      const Number       range =
        1. - 1. / PointCylinder::power(Number(1. + length / l), n);
      Number sum = 0.;
      for (unsigned int q = 0; q < depth.size(); ++q)
        {
          const Number y      = 1. - depth.point(q)[0] * range;
          const Number w      = pow(y, -1. / n);
          const Number s      = begin + (sign * l) * (w - 1.);
          const Number gap_q  = chord.gap + s * chord.gap_s;
          const Number side_q = chord.side + s * chord.side_s;
          const Number x_q =
            sqrt((R2 + gap_q) * (R2 + gap_q) + side_q * side_q);
          const Number h_q =
            (gap_q * (2. * R2 + gap_q) + side_q * side_q) / (x_q + R2);
          sum += depth.weight(q) * w / y * potential(h_q, x_q);
        }
      return sum * range * l / double(n);
    }

    unsigned int      m;
    double            R1, R2;
    PointCylinder     potential;
    dealii::QGauss<1> depth;
    unsigned int      n_lateral;
  };
} // namespace Setae

#endif
