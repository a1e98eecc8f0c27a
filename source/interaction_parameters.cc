// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#include <setae/base/entries.h>
#include <setae/base/entry_patterns.h>
#include <setae/laws/all.h>
#include <setae/scene.h>

namespace Setae
{
  using namespace dealii;
  using namespace EntryPatterns;



  void
  InteractionParameters::add_parameters(Entries &prm)
  {
    if (law.empty())
      law = TabulatedDiskCylinder::name;
    prm.add_parameter("law",
                      law,
                      "The reduced law. " + Laws::descriptions() + ".",
                      Patterns::Selection(Laws::names()));
    prm.add_parameter(
      "target ends",
      target_ends,
      "The end of a target: 'clamped' keeps the infinite cylinder at the last "
      "point (SBIP), too much by about a factor of two; 'finite' integrates "
      "over the sections of a target that are next to its end too, with the "
      "source as the infinite cylinder, and lets the target fade there; "
      "'by law' is finite for laws that know the tilt of a section, which "
      "cannot be clamped. Finite ends are flat. Contact has round ends only; a "
      "scene with flat ends throughout takes a repulsive potential instead.",
      Patterns::Selection("by law|clamped|finite"));
    prm.add_parameter("source",
                      source,
                      "The fibers that are integrated over (the papers' slave "
                      "side), by name, or 'all'. Two fibers that are both in "
                      "source and target interact once, the one listed first "
                      "being the source.",
                      names());
    prm.add_parameter("target",
                      target,
                      "The fibers that are projected onto (the papers' master "
                      "side), by name, or 'all'.",
                      names());
    prm.add_parameter("two half passes",
                      two_half_passes,
                      "Let every pair interact twice at half strength, each "
                      "fiber once being the source.");
    prm.add_parameter("self interaction",
                      self_interaction,
                      "Let the cells of one fiber interact with each other, in "
                      "two half passes.");
    prm.add_parameter("excluded neighbors",
                      n_excluded_neighbors,
                      "In the self-interaction, how many cells on either side "
                      "of a cell do not interact with it.",
                      positive_integer());
    prm.add_parameter("exponents",
                      exponents,
                      "The exponents m of the point potential sum k_m r^-m.",
                      Patterns::List(positive_integer(), 1));
    prm.add_parameter(
      "prefactors",
      prefactors,
      "The prefactors k_m [energy length^m]; negative attracts.",
      Patterns::List(Patterns::Double(), 0));
    prm.add_parameter(
      "distribution",
      distribution,
      "Whether the points are in the volume of the fibers, with "
      "their number density, or on their surface, with their "
      "surface density; the laws for small gaps know the volume "
      "only.",
      Patterns::Selection("volume|surface"));
    prm.add_parameter("strength",
                      strength,
                      "A factor of the interaction, a formula of the time t: "
                      "'min(1, t/0.1)' switches it on gradually.",
                      Patterns::Anything());
    prm.add_parameter("penalty",
                      penalty,
                      "For contact: force per length and penetration "
                      "[force/length^2], positive.",
                      non_negative());
    prm.add_parameter("equilibrium gap",
                      equilibrium_gap,
                      "Instead of prefactors, for Lennard-Jones: the gap at "
                      "which two infinite parallel fibers feel no force by the "
                      "law of this interaction, without regularization and "
                      "cutoff [length]. With 'force minimum' or 'hamaker "
                      "constant'.",
                      non_negative());
    prm.add_parameter("force minimum",
                      force_minimum,
                      "Instead of prefactors, for Lennard-Jones: the most "
                      "attractive force per length of two infinite parallel "
                      "fibers by the law of this interaction, without "
                      "regularization and cutoff [force/length], negative.",
                      Patterns::Double(-infinity, 0.));
    prm.add_parameter(
      "hamaker constant",
      hamaker_constant,
      "Instead of a prefactor: A = -pi^2 rho_1 rho_2 k_6 of "
      "the two materials [energy], the same for all pairs of "
      "fibers of this interaction whatever their number "
      "densities; positive attracts. Alone, with exponents = 6, "
      "or with 'equilibrium gap', which then says how much the "
      "fibers repel each other (exponents = 6, 12).",
      Patterns::Double());
    prm.add_parameter("cutoff",
                      cutoff,
                      "The gap beyond which there is no interaction [length]; "
                      "0 means none, which only long-range laws allow.",
                      non_negative());
    prm.add_parameter("switch width",
                      switch_width,
                      "The part of the cutoff over which the interaction is "
                      "switched off smoothly.",
                      Patterns::Double(0., 1.));
    prm.add_parameter("cutoff of",
                      cutoff_of,
                      "For a law of the offset, what is switched off: the "
                      "'energy', whose slope adds an attraction, or the "
                      "'forces', as if those beyond the cutoff were left out "
                      "(ISSIP Sec. 6.5). The latter have no potential, so that "
                      "instabilities cannot be passed.",
                      Patterns::Selection("energy|forces"));
    prm.add_parameter("regularization gap",
                      regularization,
                      "Below this gap the law goes on with a force linear in "
                      "the gap (SBIP app. C). A state with a smaller gap is "
                      "never accepted. 0 switches it off [length].",
                      non_negative());
    prm.add_parameter("skin",
                      skin,
                      "How far beyond the cutoff partners are searched, so "
                      "that the search is repeated only when points have moved "
                      "by half of it [length]; 0 takes half of the cutoff, or "
                      "with a far field a tenth of the shortest cell.",
                      non_negative());
    prm.add_parameter("far field tolerance",
                      far_field_tolerance,
                      "For the law 'monopole' without a cutoff: cells that are "
                      "far apart interact through the moments of clusters of "
                      "cells, in a time that grows as n log n instead of n^2, "
                      "with forces that err by this part of the sum of the "
                      "magnitudes at most. 0 sums over all pairs of points.",
                      Patterns::Double(0., .1));
    prm.add_parameter("integration rule",
                      integration_rule,
                      "The rule of every integration segment: 'gauss', or "
                      "'midpoint', which has one point. Many equal segments "
                      "with the midpoint rule converge fast for sharply "
                      "peaked laws of two sections once the points are closer "
                      "than half of the gap (ISSIP Sec. 6.7).",
                      Patterns::Selection("gauss|midpoint"));
    prm.add_parameter("integration segments",
                      n_segments,
                      "Equal parts of a cell, each with its own points.",
                      positive_integer());
    prm.add_parameter("gauss points",
                      n_gauss_points,
                      "Gauss points per integration segment; the midpoint rule "
                      "does not use them.",
                      positive_integer());
    prm.add_parameter("integration tolerance",
                      integration_tolerance,
                      "Halve integration segments where fibers are near until "
                      "the points on each are enough for about this relative "
                      "error, and keep them long elsewhere; for contact, of "
                      "the force at a penetration of a two-hundredth of the "
                      "sum of the radii. 0 leaves all segments equal, as they "
                      "always are with the midpoint rule and for laws of the "
                      "offset.",
                      Patterns::Double(0., .1));
    prm.add_parameter("frame",
                      frame,
                      "For a law of the offset, along what it is measured: the "
                      "sum of both unit tangents ('averaged'), or the tangent "
                      "of the source ('source', ISSIP Sec. 5.3).",
                      Patterns::Selection("averaged|source"));
    prm.add_parameter("interaction moments",
                      interaction_moments,
                      "For a law of the offset, whether the sections exert "
                      "moments on each other as the energy asks for. Without "
                      "them (ISSIP eq. 50) moments are not in balance, there "
                      "is no potential, and instabilities cannot be passed.");
    prm.add_parameter("section points",
                      section_points,
                      "For the law 'section-quadrature': the points of a "
                      "section, in depth and along the edge.",
                      Patterns::List(positive_integer(), 2, 2));
    prm.add_parameter("law tolerance",
                      law_tolerance,
                      "For the law 'tabulated-disk-cylinder': the relative "
                      "error of the energy of a section. The cost of the table "
                      "grows as its power -3/4.",
                      Patterns::Double(1e-6, .1));
  }
} // namespace Setae
