// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_verification_chords_h
#define setae_verification_chords_h

#include <setae/verification/disks.h>
#include <setae/verification/segments.h>

#include <vector>

namespace Setae
{
  namespace References
  {
    /**
     * The parallel chords of a disk of radius R: at the angle chi their half
     * length is R cos(chi), and they are R sin(chi) from the center. They are
     * seen from one of them, from which chi is counted as a turn, so that small
     * differences do not cancel.
     */
    class Chords
    {
    public:
      Chords(double radius, double angle = 0.);

      Chords
      seen_from(double turn) const;

      double
      radius() const;

      /** The turn to the first one, of length zero. */
      double
      first_turn() const;

      /** The turn to the last one, of length zero. */
      double
      last_turn() const;

      double
      half_length(double turn) const;

      double
      from_center(double turn) const;

      /** By how much from_center() grows. */
      double
      step(double turn) const;

      /** By how much half_length() shrinks. */
      double
      retreat(double turn) const;

    private:
      double R, angle, sine, cosine;
    };



    /** A chord of the first disk and one of the second disk. */
    struct PairOfChords
    {
      double height;   ///< of the first one above the plane of the second disk
      double distance; ///< of the lines
      double half_1;   ///< half length of the first one
      double half_2;   ///< half length of the second one
      double from_center_2;
      PairMeasure points;

      /** Of their nearest points. */
      double
      smallest_distance() const;
    };



    /**
     * Two disks as pairs of chords that are parallel to both planes, and hence
     * to each other: two angles are all that is left of four coordinates. The
     * pairs are seen from one of them.
     */
    class PairsOfChords
    {
    public:
      /** Seen from the two nearest ones. */
      PairsOfChords(const SectionPair &sections,
                    const Disk        &disk_1,
                    const Disk        &disk_2);

      /** Seen from a chord of the first disk and the one nearest to it. */
      PairsOfChords
      row(double turn_1) const;

      PairOfChords
      pair(double turn_1, double turn_2) const;

      /**
       * The turns of the first chord at which an end of it is above the edge of
       * the second disk, or its tip above that of the second disk, where what
       * the disks feel changes within a turn of their distance over the radius.
       */
      std::vector<double>
      crossing_edges() const;

      Chords first, second;

      /** The direction of the chords, from the second disk to the first. */
      dealii::Tensor<1, 3> along;
      dealii::Tensor<1, 3> lateral; ///< in the plane of the second disk
      dealii::Tensor<1, 3> normal;  ///< of the second disk

    private:
      PairsOfChords
      seen_from(double turn_1, double turn_2) const;

      void
      find_axes(const Disk &disk_1, const Disk &disk_2);

      double height, sideways, gap; ///< of the pair from which they are seen
      double rise, run; ///< of a step of the first disk, normal and lateral
    };
  } // namespace References
} // namespace Setae

#endif
