// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#include <setae/laws/disk_contact.h>

namespace Setae
{
  double
  DiskContactMap::direction(const Invariants<double> &x) const
  {
    constexpr unsigned int n_max            = 100;
    constexpr double       newton_tolerance = 1e-9; // the next: squared
    constexpr double       rounding_error   = 1e-15;

    // The start is the solution with D and W as for psi = 0: exact without
    // tilt.
    const double R = R1 * R1;
    const double D = x.gap + R1;
    const double Q = (D * D + R * (1. - x.T)) / (2. * D);
    const double B = x.d * Q - (x.S - x.T) * R;
    double       u = 2. * R / (B + std::sqrt(B * B + 4. * x.S * x.T * R * R));

    double low = 0., high = 1. / std::max(x.T, 1e-100);
    for (unsigned int i = 0; i < n_max; ++i)
      {
        const Stationarity<double> f = stationarity(x, u);
        // With D <= 0 the direction misses the disk: much too large.
        (f.D > 0. && f.value < 0. ? low : high) = u;

        const double last = u, next = u - f.value / f.slope;
        const bool is_newton = f.D > 0. && next > low * (1. - rounding_error) &&
                               next < high * (1. + rounding_error);
        u = is_newton ? next : .5 * (low + high);
        if (std::abs(u - last) <=
            (is_newton ? newton_tolerance : rounding_error) * u)
          break;
      }
    return u;
  }



  GapAngleTiltDerivatives
  DiskContactMap::derivatives(const DiskContact<double> &contact,
                              const ContactDerivatives  &f,
                              const double               gap,
                              const double               cosine,
                              const double               tilt) const
  {
    const double H = contact.H, W = contact.W, C = contact.C;
    const double R  = R1 * R1;
    const double q2 = 1. / (W + H * H), q = std::sqrt(q2), q3 = q * q2;
    const double Q = 1. / q, X = H + R2 + Q;

    // z1 = d^2 = X^2 + N / Q^2 and z2 = (tilt d)^2 = p V^2
    const double N = (R - W) * (W - R * C), N_W = R * (1. + C) - 2. * W,
                 N_C = -R * (R - W);
    const double Q_H = H * q, Q_W = .5 * q;
    const double A_H = -2. * H * q2 * q2, A_W = -q2 * q2; // of 1 / Q^2
    const double z1_H = 2. * X * (1. + Q_H) + N * A_H;
    const double z1_W = 2. * X * Q_W + N_W * q2 + N * A_W;
    const double z1_C = N_C * q2;

    const double p = 1. - W / R, p_W = -1. / R;
    const double U = W - R * C, V = X - U * q;
    const double q_H = -H * q3, q_W = -.5 * q3;
    const double V_H = 1. + Q_H - U * q_H, V_W = Q_W - q - U * q_W, V_C = R * q;
    const double z2_H = 2. * p * V * V_H;
    const double z2_W = V * (p_W * V + 2. * p * V_W);
    const double z2_C = 2. * p * V * V_C;

    // The first derivatives in z are the multipliers of these two equations.
    const double inverse = 1. / (z1_H * z2_W - z1_W * z2_H);
    const double H1 = z2_W * inverse, W1 = -z2_H * inverse;
    const double H2 = -z1_W * inverse, W2 = z1_H * inverse;
    const double H3 = -(H1 * z1_C + H2 * z2_C), W3 = -(W1 * z1_C + W2 * z2_C);
    const double E1 = H1 * f.H + W1 * f.W;
    const double E2 = H2 * f.H + W2 * f.W;
    const double E3 = f.C + H3 * f.H + W3 * f.W;

    // The second derivatives of f - E1 z1 - E2 z2
    const double Q_HH = W * q3, Q_HW = -.5 * H * q3, Q_WW = -.25 * q3;
    const double A_HH = q2 * q2 * (8. * H * H * q2 - 2.),
                 A_HW = 4. * H * q2 * q2 * q2, A_WW = 2. * q2 * q2 * q2;
    const double z1_HH =
      2. * (1. + Q_H) * (1. + Q_H) + 2. * X * Q_HH + N * A_HH;
    const double z1_HW =
      2. * (1. + Q_H) * Q_W + 2. * X * Q_HW + N_W * A_H + N * A_HW;
    const double z1_WW =
      2. * Q_W * Q_W + 2. * X * Q_WW - 2. * q2 + 2. * N_W * A_W + N * A_WW;
    const double z1_HC = N_C * A_H, z1_WC = R * q2 + N_C * A_W;

    const double q_HH = q3 * (3. * H * H * q2 - 1.), q_HW = 1.5 * H * q3 * q2,
                 q_WW = .75 * q3 * q2;
    const double V_HH = Q_HH - U * q_HH, V_HW = Q_HW - q_H - U * q_HW,
                 V_WW = Q_WW - 2. * q_W - U * q_WW;
    const double V_HC = R * q_H, V_WC = R * q_W;
    const double z2_HH = 2. * p * (V_H * V_H + V * V_HH);
    const double z2_HW = 2. * (p_W * V * V_H + p * (V_H * V_W + V * V_HW));
    const double z2_WW = 4. * p_W * V * V_W + 2. * p * (V_W * V_W + V * V_WW);
    const double z2_HC = 2. * p * (V_H * V_C + V * V_HC);
    const double z2_WC = 2. * (p_W * V * V_C + p * (V_W * V_C + V * V_WC));
    const double z2_CC = 2. * p * V_C * V_C;

    const double HH = f.HH - E1 * z1_HH - E2 * z2_HH;
    const double HW = f.HW - E1 * z1_HW - E2 * z2_HW;
    const double HC = f.HC - E1 * z1_HC - E2 * z2_HC;
    const double WW = f.WW - E1 * z1_WW - E2 * z2_WW;
    const double WC = f.WC - E1 * z1_WC - E2 * z2_WC;
    const double CC = f.CC - E2 * z2_CC;

    const auto product =
      [&](const double Ha, const double Wa, const double Hb, const double Wb) {
        return HH * Ha * Hb + HW * (Ha * Wb + Wa * Hb) + WW * Wa * Wb;
      };
    const double E11 = product(H1, W1, H1, W1), E12 = product(H1, W1, H2, W2),
                 E22 = product(H2, W2, H2, W2);
    const double E13 = product(H1, W1, H3, W3) + HC * H1 + WC * W1;
    const double E23 = product(H2, W2, H3, W3) + HC * H2 + WC * W2;
    const double E33 = product(H3, W3, H3, W3) + 2. * (HC * H3 + WC * W3) + CC;

    // z1 = d^2, z2 = tilt^2 d^2, z3 = cosine^2
    const double            d = gap + (R1 + R2), t = tilt, c = cosine;
    const double            a1 = 2. * d, a2 = 2. * t * t * d; // by the gap
    const double            b2 = 2. * t * d * d;              // by the tilt
    GapAngleTiltDerivatives result;
    result.value = f.value;
    result.g     = E1 * a1 + E2 * a2;
    result.c     = 2. * c * E3;
    result.t     = E2 * b2;
    result.gg = 2. * E1 + 2. * t * t * E2 + a1 * a1 * E11 + 2. * a1 * a2 * E12 +
                a2 * a2 * E22;
    result.gc = 2. * c * (a1 * E13 + a2 * E23);
    result.gt = 4. * t * d * E2 + b2 * (a1 * E12 + a2 * E22);
    result.cc = 2. * E3 + 4. * c * c * E33;
    result.ct = 2. * c * b2 * E23;
    result.tt = 2. * d * d * E2 + b2 * b2 * E22;
    return result;
  }
} // namespace Setae
