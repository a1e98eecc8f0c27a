// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_search_neighbor_list_h
#define setae_search_neighbor_list_h

#include <deal.II/base/array_view.h>
#include <deal.II/base/exceptions.h>

#include <setae/search/bounding_box.h>

#include <array>
#include <functional>
#include <vector>

namespace Setae
{
  /**
   * A compressed list of the cells (targets) that may come within a given
   * reach of each of the cells that look for partners (sources), in the manner
   * of Verlet: it contains somewhat more pairs than are within reach, and in
   * return stays valid while the cells move a little. Pure geometry: a cell is
   * its four Bernstein-Bezier control points, and which pairs make sense is
   * the caller's to say.
   *
   * <h3>No pair is missed</h3>
   *
   * Let @f$P_k@f$ and @f$Q_k@f$ be the control points of two cells when the
   * list was built and @f$p_k@f$ and @f$q_k@f$ those of now. A point of a cell
   * is a convex combination of its control points, with weights that depend
   * on the reference coordinate @f$x@f$ only. So, as long as
   * @f$|p_k-P_k|\le s/2@f$ for all control points (@f$s@f$ is the skin), every
   * point of a cell is within @f$s/2@f$ of where it was, and two points that
   * are now within the reach @f$R@f$ of each other were within
   * @f[
   *   R + \frac s2 + \frac s2 = R + s .
   * @f]
   * All pairs of cells that had points within @f$R+s@f$ when the list was
   * built are therefore all that may be within @f$R@f$ now. Three tests of
   * increasing cost and sharpness find them, and each of them bounds the
   * distance of the curves from below:
   *
   * 1. The box of the source, enlarged by @f$R+s@f$ on all sides, intersects
   *    the box of the target. Otherwise the curves differ by more than
   *    @f$R+s@f$ in one of the coordinates. The boxes of the targets are in an
   *    R-tree, so that @f$n@f$ cells cost @f$O(n\log n)@f$.
   * 2. The Euclidean distance of the two boxes is at most @f$R+s@f$.
   * 3. The convex hulls of the control points are not further than @f$R+s@f$
   *    apart in the direction @f$w@f$ that connects the chords of the cells
   *    where these are closest. Any direction gives a bound,
   *    @f[
   *      \min_k w\cdot Q_k - \max_k w\cdot P_k \le |w|\,|q-p|
   *      \quad\text{for all points } p, q \text{ of the two cells},
   *    @f]
   *    so that nothing depends on the accuracy of @f$w@f$. For straight cells
   *    it is the exact distance, whereas the boxes of long cells across the
   *    axes are almost empty.
   *
   * All this holds up to the rounding of the coordinates.
   */
  class NeighborList
  {
  public:
    /** The Bernstein-Bezier control points of a cell [length]. */
    using ControlPoints = std::array<Tensor<1, 3>, 4>;

    /** Says whether a target may be a partner of a source. */
    using Admissible =
      std::function<bool(const unsigned int source, const unsigned int target)>;

    /**
     * @param reach largest distance of two centerlines at which they may still
     *   interact: cutoff of the gap plus the radii [length]
     * @param skin allowance for motion [length], positive: a large one makes
     *   for few but long lists
     *
     * Either may be infinite: then the list is built once, with all pairs.
     */
    NeighborList(const double reach, const double skin);

    /**
     * Whether the list may miss pairs of @p cells: it was never built, or the
     * number of cells differs, or a control point has moved by more than half
     * of the skin since.
     */
    bool
    needs_rebuild(const std::vector<ControlPoints> &cells) const;

    /**
     * Find the candidates.
     *
     * @param cells control points of all cells [length]; they must be finite
     * @param sources indices of the cells that look for partners
     * @param targets indices of the cells that can be found, each one once;
     *   they may be sources too
     * @param admissible excludes pairs: a cell and itself (which is not
     *   excluded otherwise), neighbors on a fiber, one of the two orders, ...;
     *   asked only for pairs whose boxes are close
     */
    void
    build(const std::vector<ControlPoints> &cells,
          const std::vector<unsigned int>  &sources,
          const std::vector<unsigned int>  &targets,
          const Admissible                 &admissible);

    /** The sources as they were given to build(). */
    const std::vector<unsigned int> &
    sources() const;

    /**
     * The candidates for the source <code>sources()[i]</code>, ascending.
     * The view is valid until the next call of build().
     */
    dealii::ArrayView<const unsigned int>
    targets(const unsigned int i) const;

    /** Number of candidate pairs. */
    std::size_t
    n_pairs() const;

    /** How often the list was built. */
    unsigned int
    n_builds() const;

    DeclException2(ExcInvalidRange,
                   double,
                   double,
                   << "A neighbor list needs a reach that is not negative and "
                   << "a positive skin, but got " << arg1 << " and " << arg2
                   << '.');

    DeclException1(ExcNotFinite,
                   unsigned int,
                   << "The control points of cell " << arg1
                   << " are not finite.");

  private:
    const double reach;
    const double skin;

    /** The cells for which the list was built. */
    std::vector<ControlPoints> reference;

    std::vector<unsigned int> source_cells;

    /** The candidates of source i are those from offsets[i] to offsets[i+1]. */
    std::vector<std::size_t>  offsets;
    std::vector<unsigned int> candidates;

    unsigned int build_counter = 0;
  };
} // namespace Setae

#endif
