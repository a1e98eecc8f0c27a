// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_base_jet_h
#define setae_base_jet_h

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

namespace Setae
{
  /**
   * A number with its first and second derivatives in n variables, for laws
   * that are sums over many points. Its Hessian is stored once, which makes it
   * several times faster than nested numbers of first order.
   */
  template <unsigned int n>
  class Jet
  {
  public:
    /** A constant. */
    Jet(const double value = 0.)
      : value(value)
    {}

    /** The variable number @p i. */
    static Jet
    variable(const unsigned int i, const double value)
    {
      Jet result(value);
      result.first[i] = 1.;
      return result;
    }

    /** The number whose second derivatives are @p second, row by row. */
    Jet(const double                              value,
        const std::array<double, n>              &first,
        const std::array<double, n *(n + 1) / 2> &second)
      : value(value)
      , first(first)
      , second(second)
    {}

    double
    val() const
    {
      return value;
    }

    double
    d(const unsigned int i) const
    {
      return first[i];
    }

    /** @p i at least @p j. */
    double
    dd(const unsigned int i, const unsigned int j) const
    {
      return second[i * (i + 1) / 2 + j];
    }

    /** f(x) for a function with value f0 and derivatives f1, f2 at x. */
    static Jet
    function(const Jet &x, const double f0, const double f1, const double f2)
    {
      Jet result(f0);
      for (unsigned int i = 0, ij = 0; i < n; ++i)
        {
          result.first[i] = f1 * x.first[i];
          for (unsigned int j = 0; j <= i; ++j, ++ij)
            result.second[ij] =
              f1 * x.second[ij] + f2 * x.first[i] * x.first[j];
        }
      return result;
    }

    Jet &
    operator+=(const Jet &x)
    {
      value += x.value;
      for (unsigned int i = 0; i < n; ++i)
        first[i] += x.first[i];
      for (unsigned int i = 0; i < n_second; ++i)
        second[i] += x.second[i];
      return *this;
    }

    Jet &
    operator*=(const double factor)
    {
      value *= factor;
      for (double &d : first)
        d *= factor;
      for (double &d : second)
        d *= factor;
      return *this;
    }

    Jet &
    operator*=(const Jet &x)
    {
      for (unsigned int i = 0, ij = 0; i < n; ++i)
        for (unsigned int j = 0; j <= i; ++j, ++ij)
          second[ij] = value * x.second[ij] + x.value * second[ij] +
                       first[i] * x.first[j] + first[j] * x.first[i];
      for (unsigned int i = 0; i < n; ++i)
        first[i] = value * x.first[i] + x.value * first[i];
      value *= x.value;
      return *this;
    }

    friend Jet
    operator-(Jet x)
    {
      return x *= -1.;
    }

    friend Jet
    operator+(Jet x, const Jet &y)
    {
      return x += y;
    }

    friend Jet
    operator-(const Jet &x, Jet y)
    {
      y *= -1.;
      return y += x;
    }

    friend Jet
    operator*(Jet x, const Jet &y)
    {
      return x *= y;
    }

    friend Jet
    operator*(const double factor, Jet x)
    {
      return x *= factor;
    }

    friend Jet
    operator*(Jet x, const double factor)
    {
      return x *= factor;
    }

    friend Jet
    operator/(Jet x, const Jet &y)
    {
      const double r = 1. / y.value;
      return x *= function(y, r, -r * r, 2. * r * r * r);
    }

    friend Jet
    operator/(Jet x, const double y)
    {
      return x *= 1. / y;
    }

    friend bool
    operator<(const Jet &x, const Jet &y)
    {
      return x.value < y.value;
    }

    friend bool
    operator>(const Jet &x, const Jet &y)
    {
      return x.value > y.value;
    }

    friend bool
    operator>=(const Jet &x, const Jet &y)
    {
      return x.value >= y.value;
    }

    friend bool
    operator<=(const Jet &x, const Jet &y)
    {
      return x.value <= y.value;
    }

    friend Jet
    sqrt(const Jet &x)
    {
      const double root = std::sqrt(x.value);
      return function(x, root, .5 / root, -.25 / (x.value * root));
    }

    friend Jet
    atan(const Jet &x)
    {
      const double slope = 1. / (1. + x.value * x.value);
      return function(x,
                      std::atan(x.value),
                      slope,
                      -2. * x.value * slope * slope);
    }

    friend Jet
    pow(const Jet &x, const double p)
    {
      const double power = std::pow(x.value, p);
      return function(x,
                      power,
                      p * power / x.value,
                      p * (p - 1.) * power / (x.value * x.value));
    }

    /** f of some numbers whose second derivatives it has in all of them. */
    template <unsigned int k>
    static Jet
    function(const std::array<Jet, k> &x, const Jet<k> &f)
    {
      Jet result(f.val());
      for (unsigned int a = 0; a < k; ++a)
        {
          for (unsigned int i = 0; i < n; ++i)
            result.first[i] += f.d(a) * x[a].first[i];
          for (unsigned int i = 0; i < n_second; ++i)
            result.second[i] += f.d(a) * x[a].second[i];
          for (unsigned int b = 0; b < k; ++b)
            {
              const double f_ab = f.dd(std::max(a, b), std::min(a, b));
              for (unsigned int i = 0, ij = 0; i < n; ++i)
                for (unsigned int j = 0; j <= i; ++j, ++ij)
                  result.second[ij] += f_ab * x[a].first[i] * x[b].first[j];
            }
        }
      return result;
    }

  private:
    static constexpr unsigned int n_second = n * (n + 1) / 2;

    double                       value;
    std::array<double, n>        first  = {};
    std::array<double, n_second> second = {};
  };

  /**
   * A function of few numbers, which is cheaper with the derivatives in these
   * than in all that they depend on.
   */
  template <typename Function, typename Number, typename... Numbers>
  Number
  evaluate_reduced(const Function &function,
                   const Number   &x,
                   const Numbers &...others)
  {
    return function(x, others...);
  }

  template <typename Function, unsigned int n, typename... Jets>
  Jet<n>
  evaluate_reduced(const Function &function,
                   const Jet<n>   &x,
                   const Jets &...others)
  {
    constexpr unsigned int      k        = 1 + sizeof...(others);
    const std::array<Jet<n>, k> all      = {{x, others...}};
    unsigned int                next     = 0;
    const auto                  variable = [&](const Jet<n> &y) {
      return Jet<k>::variable(next++, y.val());
    };
    // Braces evaluate in their order
    const std::array<Jet<k>, k> variables = {
      {variable(x), variable(others)...}};
    return Jet<n>::template function<k>(all, std::apply(function, variables));
  }
} // namespace Setae

#endif
