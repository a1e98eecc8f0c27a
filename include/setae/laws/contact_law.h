// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_laws_contact_law_h
#define setae_laws_contact_law_h

#include <setae/base/invariants.h>
#include <setae/laws/disk_contact.h>
#include <setae/laws/point_potential.h>
#include <setae/laws/short_range.h>

namespace Setae
{
  /**
   * What the laws of a disk and a cylinder at any angle have in common: they
   * are functions of a DiskContact, which is computed from the gap,
   * @f$c=t_1\cdot t_2@f$ and the tilt @f$\tau=t_1\cdot n@f$.
   *
   * The cutoff acts on the gap. The regularization acts on the softened
   * distance H, below the one of parallel fibers at the regularization gap;
   * where the disk leans over, H is smaller at the same distance, so that it
   * begins earlier, by less than a factor of two. Where the center of the disk
   * lies in the target nothing depends on the gap any more.
   *
   * @tparam Law Has `ContactDerivatives derivatives(DiskContact<double>)` and
   * `Number value(DiskContact<Number>)`.
   */
  template <typename Law>
  class ContactLaw
  {
  public:
    static constexpr Invariants   depends_on    = Invariants::gap_angle_tilt;
    static constexpr bool         is_long_range = false;
    static constexpr unsigned int smallest_exponent = 6;

    ContactLaw(const SectionPair &sections, const GapRange &range)
      : R1(sections.radius_1)
      , R2(sections.radius_2)
      , map(R1, R2)
      , cutoff_switch(One(), range.cutoff_begin, range.cutoff)
      , regularized(range.regularization > 0.)
      , H_regularization(range.regularization *
                         (range.regularization + 2. * R1) /
                         (2. * (range.regularization + R1)))
    {}

    /** How the disk stands before the cylinder. */
    DiskContact<double>
    contact(const double gap, const double cosine, const double tilt) const
    {
      return map.contact(std::max(gap, smallest_gap()), cosine, tilt);
    }

    /** Energy per length of the source, with derivatives, at a contact. */
    GapAngleTiltDerivatives
    operator()(const DiskContact<double> &contact,
               const double               gap,
               const double               cosine,
               const double               tilt) const
    {
      const ContactDerivatives f =
        static_cast<const Law *>(this)->derivatives(contact);
      GapAngleTiltDerivatives e = map.derivatives(
        contact, f, std::max(gap, smallest_gap()), cosine, tilt);
      if (gap < smallest_gap())
        e.g = e.gg = e.gc = e.gt = 0.;

      const GapDerivatives s = cutoff_switch.derivatives(gap);
      e.gg = s.value * e.gg + 2. * s.first * e.g + s.second * e.value;
      e.gc = s.value * e.gc + s.first * e.c;
      e.gt = s.value * e.gt + s.first * e.t;
      e.cc *= s.value;
      e.ct *= s.value;
      e.tt *= s.value;
      e.g = s.value * e.g + s.first * e.value;
      e.c *= s.value;
      e.t *= s.value;
      e.value *= s.value;
      return e;
    }

    GapAngleTiltDerivatives
    operator()(const double gap, const double cosine, const double tilt) const
    {
      return (*this)(contact(gap, cosine, tilt), gap, cosine, tilt);
    }

    /** The energy alone, on any number type. */
    template <typename Number>
    Number
    energy(const Number &gap, const Number &cosine, const Number &tilt) const
    {
      using Map         = DiskContactMap;
      const Number held = gap < smallest_gap() ? Number(smallest_gap()) : gap;
      const double direction = map.direction(Map::double_of(held),
                                             Map::double_of(cosine),
                                             Map::double_of(tilt));
      return static_cast<const Law *>(this)->value(
               map.contact(held, cosine, tilt, direction)) *
             cutoff_switch.value(gap);
    }

    /** DiskContact::H, on any number type. */
    template <typename Number>
    Number
    softened_distance(const Number &gap,
                      const Number &cosine,
                      const Number &tilt) const
    {
      using Map         = DiskContactMap;
      const Number held = gap < smallest_gap() ? Number(smallest_gap()) : gap;
      const double direction = map.direction(Map::double_of(held),
                                             Map::double_of(cosine),
                                             Map::double_of(tilt));
      return map.contact(held, cosine, tilt, direction).H;
    }

    /** The gap [length] from which on the law is zero. */
    double
    cutoff() const
    {
      return cutoff_switch.cutoff();
    }

    /** Whether the law can be evaluated at @p clearance of the contact. */
    bool
    admits(const double clearance) const
    {
      return clearance > 0. || regularized;
    }

  protected:
    double         R1, R2;
    DiskContactMap map;

  private:
    struct One
    {
      template <typename Number>
      Number
      value(const Number &) const
      {
        return 1.;
      }

      GapDerivatives
      derivatives(const double) const
      {
        return {1., 0., 0.};
      }

      bool
      admits(const double) const
      {
        return true;
      }
    };

    /** The center of the disk on the surface of the target. */
    double
    smallest_gap() const
    {
      return -R1 * (1. - 1e-6);
    }

    SmoothCutoff<One> cutoff_switch;
    bool              regularized;

  protected:
    /** Below this H the law is regularized [length]. */
    double H_regularization;
  };



  /**
   * x, but constant below one half of @p begin, with two continuous derivatives:
   * what varies slowly beside a regularized power stops to vary.
   */
  class Held
  {
  public:
    explicit Held(const double begin)
      : begin(begin)
    {}

    template <typename Number>
    Number
    value(const Number &x) const
    {
      if (x >= begin)
        return x;
      if (!(x > .5 * begin))
        return .75 * begin;
      const Number y = 2. * x / begin - 1.;
      return begin * (.75 + .5 * y * y * y * y * (2.5 - y * (3. - y)));
    }

    GapDerivatives
    derivatives(const double x) const
    {
      if (x >= begin)
        return {x, 1., 0.};
      if (!(x > .5 * begin))
        return {.75 * begin, 0., 0.};
      const double y = 2. * x / begin - 1.;
      return {value(x),
              y * y * y * (10. - y * (15. - 6. * y)),
              60. * y * y * (1. - y) * (1. - y) / begin};
    }

  private:
    double begin;
  };
} // namespace Setae

#endif
