// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_base_law_derivatives_h
#define setae_base_law_derivatives_h

namespace Setae
{
  /**
   * A function of the gap and its first two derivatives.
   */
  struct GapDerivatives
  {
    double value  = 0.;
    double first  = 0.;
    double second = 0.;
  };



  /**
   * Value and derivatives of a law of the gap g and of c = cos(alpha), the
   * cosine between the two tangents.
   */
  struct GapAngleDerivatives
  {
    double value = 0.;
    double g = 0., c = 0.;
    double gg = 0., gc = 0., cc = 0.;

    friend GapAngleDerivatives
    operator*(const double factor, const GapAngleDerivatives &law)
    {
      return {factor * law.value,
              factor * law.g,
              factor * law.c,
              factor * law.gg,
              factor * law.gc,
              factor * law.cc};
    }
  };



  /**
   * Value and derivatives of a law of the offset o and the gap g.
   */
  struct OffsetGapDerivatives
  {
    double value = 0.;
    double o = 0., g = 0.;
    double oo = 0., og = 0., gg = 0.;

    OffsetGapDerivatives &
    operator+=(const OffsetGapDerivatives &other)
    {
      value += other.value;
      o += other.o;
      g += other.g;
      oo += other.oo;
      og += other.og;
      gg += other.gg;
      return *this;
    }

    friend OffsetGapDerivatives
    operator*(const double factor, const OffsetGapDerivatives &law)
    {
      return {factor * law.value,
              factor * law.o,
              factor * law.g,
              factor * law.oo,
              factor * law.og,
              factor * law.gg};
    }
  };



  /**
   * Value and derivatives of a law of the gap g, of c = cos(alpha) and of the
   * tilt t, the component of the source's tangent along the connecting vector.
   */
  struct GapAngleTiltDerivatives
  {
    double value = 0.;
    double g = 0., c = 0., t = 0.;
    double gg = 0., gc = 0., gt = 0., cc = 0., ct = 0., tt = 0.;

    friend GapAngleTiltDerivatives
    operator*(const double factor, const GapAngleTiltDerivatives &law)
    {
      return {factor * law.value,
              factor * law.g,
              factor * law.c,
              factor * law.t,
              factor * law.gg,
              factor * law.gc,
              factor * law.gt,
              factor * law.cc,
              factor * law.ct,
              factor * law.tt};
    }
  };
} // namespace Setae

#endif
