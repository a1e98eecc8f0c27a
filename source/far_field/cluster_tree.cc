// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#include <deal.II/base/exceptions.h>

#include <setae/far_field/cluster_tree.h>
#include <setae/search/bounding_box.h>

#include <algorithm>

namespace Setae
{
  namespace
  {
    BoundingBox<3>
    box_of(const std::vector<ClusterTree::ControlPoints> &cells,
           const ClusterTree::Chain                      &chain)
    {
      BoundingBox<3> box = bounding_box(cells[chain.first_cell]);
      for (unsigned int i = 1; i < chain.n_cells; ++i)
        box.merge_with(bounding_box(cells[chain.first_cell + i]));
      return box;
    }



    double
    largest_distance(const ClusterTree::ControlPoints &points,
                     const Tensor<1, 3>               &center)
    {
      double result = 0.;
      for (const Tensor<1, 3> &point : points)
        result = std::max(result, (point - center).norm());
      return result;
    }
  } // namespace



  void
  ClusterTree::clear(const unsigned int n_cells)
  {
    clusters.clear();
    cluster_of_cell.assign(n_cells, none);
  }



  unsigned int
  ClusterTree::add_tree(const std::vector<ControlPoints> &cells,
                        const std::vector<Chain>         &all_chains,
                        std::vector<unsigned int>         members)
  {
    Assert(!members.empty(), dealii::ExcEmptyObject());
    return add_group(cells, all_chains, members.begin(), members.end(), none);
  }



  /** Fibers are divided across the longest side of the box of their centers. */
  unsigned int
  ClusterTree::add_group(const std::vector<ControlPoints>   &cells,
                         const std::vector<Chain>           &all_chains,
                         std::vector<unsigned int>::iterator first,
                         std::vector<unsigned int>::iterator last,
                         const unsigned int                  parent)
  {
    if (last - first == 1)
      {
        const Chain &chain = all_chains[*first];
        return add_part(cells,
                        *first,
                        chain.first_cell,
                        chain.first_cell + chain.n_cells,
                        parent);
      }

    const auto center = [&](const unsigned int chain) {
      return box_of(cells, all_chains[chain]).center();
    };
    BoundingBox<3> box     = box_of(cells, all_chains[*first]);
    BoundingBox<3> centers = BoundingBox<3>({center(*first), center(*first)});
    for (auto it = first; it != last; ++it)
      {
        box.merge_with(box_of(cells, all_chains[*it]));
        centers.merge_with(BoundingBox<3>({center(*it), center(*it)}));
      }

    const unsigned int index = clusters.size();
    clusters.emplace_back();
    clusters[index].parent = parent;
    clusters[index].center = box.center();
    for (auto it = first; it != last; ++it)
      for (unsigned int i = 0; i < all_chains[*it].n_cells; ++i)
        clusters[index].radius =
          std::max(clusters[index].radius,
                   largest_distance(cells[all_chains[*it].first_cell + i],
                                    clusters[index].center));

    unsigned int axis = 0;
    for (unsigned int c = 1; c < 3; ++c)
      if (centers.side_length(c) > centers.side_length(axis))
        axis = c;
    const auto middle = first + (last - first) / 2;
    std::nth_element(first,
                     middle,
                     last,
                     [&](const unsigned int i, const unsigned int j) {
                       return std::make_pair(center(i)[axis], i) <
                              std::make_pair(center(j)[axis], j);
                     });
    const unsigned int left =
      add_group(cells, all_chains, first, middle, index);
    const unsigned int right =
      add_group(cells, all_chains, middle, last, index);
    clusters[index].children = {{left, right}};
    return index;
  }



  unsigned int
  ClusterTree::add_part(const std::vector<ControlPoints> &cells,
                        const unsigned int                chain,
                        const unsigned int                begin,
                        const unsigned int                end,
                        const unsigned int                parent)
  {
    const unsigned int index = clusters.size();
    clusters.emplace_back();
    Cluster &cluster = clusters[index];
    cluster.parent   = parent;
    cluster.chain    = chain;
    cluster.begin    = begin;
    cluster.end      = end;
    cluster.center   = box_of(cells, {begin, end - begin}).center();
    for (unsigned int cell = begin; cell < end; ++cell)
      cluster.radius =
        std::max(cluster.radius, largest_distance(cells[cell], cluster.center));

    if (end - begin == 1)
      {
        cluster_of_cell[begin] = index;
        return index;
      }
    const unsigned int middle = begin + (end - begin) / 2;
    const unsigned int left   = add_part(cells, chain, begin, middle, index);
    const unsigned int right  = add_part(cells, chain, middle, end, index);
    clusters[index].children  = {{left, right}};
    return index;
  }



  void
  ClusterTree::find_pairs(const unsigned int A,
                          const unsigned int B,
                          const bool         within_chains,
                          const Predicate   &is_far,
                          Pairs             &pairs) const
  {
    const Cluster &a = clusters[A], &b = clusters[B];
    if (A == B)
      {
        if (a.is_cell() || (a.chain != none && !within_chains))
          return;
        const auto [left, right] = a.children;
        find_pairs(left, left, within_chains, is_far, pairs);
        find_pairs(right, right, within_chains, is_far, pairs);
        find_pairs(left, right, within_chains, is_far, pairs);
      }
    else if (is_far(A, B))
      pairs.far.emplace_back(A, B);
    else if (a.is_cell() && b.is_cell())
      pairs.near.emplace_back(A, B);
    else if (b.is_cell() || (!a.is_cell() && a.radius >= b.radius))
      for (const unsigned int child : a.children)
        find_pairs(child, B, within_chains, is_far, pairs);
    else
      for (const unsigned int child : b.children)
        find_pairs(A, child, within_chains, is_far, pairs);
  }
} // namespace Setae
