// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_far_field_taylor_expansion_h
#define setae_far_field_taylor_expansion_h

#include <deal.II/base/tensor.h>

#include <setae/laws/point_potential.h>

#include <array>
#include <vector>

namespace Setae
{
  using dealii::Tensor;

  /**
   * The interaction of two clusters of points that are far apart, each of which
   * is represented by its moments, by Taylor expansion of the potential
   * @f$\Phi(r)=\sum_m k_m r^{-m}@f$ to the order @f$p@f$ (a fast multipole
   * method in Cartesian coordinates, for any exponents).
   *
   * Points of charge @f$q_i@f$ are at @f$c_A+a_i@f$ and @f$c_B+b_j@f$; with
   * @f$R=c_A-c_B@f$, multi-indices @f$k,l@f$, the moments
   * @f$M^A_k=\sum_i q_i a_i^k/k!@f$ and @f$D_k=\partial^k\Phi(R)@f$,
   * @f[
   *   \sum_{ij} q_i q_j \Phi(|R+a_i-b_j|) \approx
   *   \sum_k M^A_k L^A_k, \qquad
   *   L^A_k = \sum_{|l|\le p-|k|} (-1)^{|l|} D_{k+l} M^B_l .
   * @f]
   * The potential at a point of A is the polynomial
   * @f$\sum_k L^A_k a^k/k!@f$. Because the sum is cut at the total degree
   * @f$p@f$, it is a function of @f$a-b@f$ only: the forces of two clusters on
   * each other add up to zero, and are the gradient of the energy, whatever the
   * order is (Dehnen 2002).
   *
   * Moments and local coefficients are arrays of size() numbers.
   */
  class TaylorExpansion
  {
  public:
    /** Value, gradient and Hessian of a potential at a point. */
    struct Derivatives
    {
      double       value = 0.;
      Tensor<1, 3> gradient;
      Tensor<2, 3> hessian;
    };

    static constexpr unsigned int max_order = 16;

    /** @param order p, from 1 to max_order. */
    TaylorExpansion(const PointPotential &potential, const unsigned int order);

    /** The number of multi-indices up to the order. */
    unsigned int
    size() const
    {
      return indices.size();
    }

    unsigned int
    order() const
    {
      return p;
    }

    /** Add the moments of a charge at the offset @p a from the center. */
    void
    add_charge(const double        charge,
               const Tensor<1, 3> &a,
               double             *moments) const;

    /**
     * Add what the moments of a charge at the offset @p a change by, per unit
     * of time, if it moves with the velocity @p v.
     */
    void
    add_moving_charge(const double        charge,
                      const Tensor<1, 3> &a,
                      const Tensor<1, 3> &v,
                      double             *moments) const;

    /**
     * Add the moments about one center to those about another one. Exact.
     *
     * @param shift from the new center to the old one [length]
     */
    void
    shift_moments(const Tensor<1, 3> &shift,
                  const double       *moments,
                  double             *shifted) const;

    /** Add the local coefficients about one center to those about another. */
    void
    shift_local(const Tensor<1, 3> &shift,
                const double       *local,
                double             *shifted) const;

    /** Derivatives of the potential at one vector, for interact(). */
    class Kernel
    {
    private:
      friend class TaylorExpansion;
      std::vector<double> D, power;
    };

    /** Evaluate all derivatives of the potential at @p R [length]. */
    void
    evaluate_kernel(const Tensor<1, 3> &R, Kernel &kernel) const;

    /**
     * Add the local coefficients of the cluster at the head of the vector of
     * @p kernel (A) that are due to the moments of the one at its foot (B).
     */
    void
    interact(const Kernel &kernel,
             const double *moments_B,
             double       *local_A) const;

    /** The same for the cluster at the foot. */
    void
    interact_reversed(const Kernel &kernel,
                      const double *moments_A,
                      double       *local_B) const;

    /** The potential of local coefficients at the offset @p a. */
    double
    value(const double *local, const Tensor<1, 3> &a) const;

    /** The same with its derivatives. */
    Derivatives
    derivatives(const double *local, const Tensor<1, 3> &a) const;

    /**
     * A bound of the error in the force between two clusters, relative to the
     * sum of the magnitudes of the forces between their points; the energy is
     * more accurate. A term of degree n of the force of two points, with
     * @f$u=a-b@f$, is at most
     * @f[ (n+1)\binom{n+m}{n+1}\,|u|^n D^{-m-n-1}, @f]
     * since the derivative of degree n + 1 of @f$r^{-m}@f$ is largest along the
     * radius. The terms from n = p on are missing. Of the first of them, the
     * sum over all points is bounded through the powers of both clusters, which
     * is much less than with their radii where few points are far out.
     *
     * @param powers_A, powers_B @f$\sum_i|q_i||a_i|^n@f$ for n = 0 ... p
     * @param radii sum of the largest @f$|a_i|@f$ and @f$|b_j|@f$ [length]
     *
     * @return Infinity if the clusters are too close for the series.
     */
    double
    relative_error(const std::vector<double> &powers_A,
                   const std::vector<double> &powers_B,
                   const double               radii,
                   const double               D) const;

  private:
    struct MultiIndex
    {
      unsigned int x, y, z;
      unsigned int cube; ///< position in an array of (p + 1)^3

      unsigned int
      degree() const
      {
        return x + y + z;
      }
    };

    /** Multi-indices that differ in z only: contiguous in every array. */
    struct Run
    {
      unsigned int x, y, begin, cube;
    };

    /** @f$a^k/k!@f$ along each axis, after two zeros for its derivatives. */
    using ScaledPowers = std::array<std::array<double, max_order + 3>, 3>;

    ScaledPowers
    scaled_powers(const Tensor<1, 3> &a) const;

    /** The first of the indices (x, y, 0) to (x, y, p - x - y). */
    unsigned int
    begin_of_run(const unsigned int x, const unsigned int y) const
    {
      return run_begins[x * (p + 1) + y];
    }

    void
    contract(const std::vector<double> &D,
             const bool                 alternate,
             const double              *moments,
             double                    *local) const;

    const PointPotential      potential;
    const unsigned int        p;
    std::vector<MultiIndex>   indices; ///< in lexicographic order
    std::vector<Run>          runs;
    std::vector<unsigned int> run_begins;
  };
} // namespace Setae

#endif
