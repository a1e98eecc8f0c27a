// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#include <deal.II/base/parameter_handler.h>

#include <setae/beams/all.h>
#include <setae/laws/all.h>
#include <setae/scene.h>

#include <limits>

namespace Setae
{
  using namespace dealii;

  namespace
  {
    constexpr double infinity = std::numeric_limits<double>::max();

    /** A double that is not negative, or not zero either. */
    Patterns::Double
    non_negative()
    {
      return Patterns::Double(0., infinity);
    }

    Patterns::Integer
    positive_integer()
    {
      return Patterns::Integer(1);
    }

    Patterns::List
    names_pattern()
    {
      return Patterns::List(Patterns::Anything(),
                            0,
                            std::numeric_limits<int>::max());
    }
  } // namespace



  void
  FiberParameters::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter("centerline",
                      centerline,
                      "The initial centerline x; y; z [length] as formulas of "
                      "s in [0, length] and of the numbers i, j, k of the copy "
                      "(from 0). Any regular parameter s will do; derivatives "
                      "are taken numerically.",
                      Patterns::Anything());
    prm.add_parameter("mesh file",
                      mesh_file,
                      "A mesh of lines in space to read the centerlines from, "
                      "in a format that deal.II's GridIn knows by its "
                      "extension (msh, vtk, inp, ...). Each connected chain of "
                      "lines becomes a fiber; 'centerline', 'length', 'cells' "
                      "and 'copies' are then not used.",
                      Patterns::Anything());
    prm.add_parameter("copies",
                      copies,
                      "The size of an array of equal fibers, up to three "
                      "numbers: '4, 5' makes 20 fibers with i = 0..3 and "
                      "j = 0..4 in their centerlines.",
                      Patterns::List(positive_integer(), 1, 3));
    prm.add_parameter("length",
                      length,
                      "The end of the range of s [length], positive.",
                      non_negative());
    prm.add_parameter("radius",
                      radius,
                      "Radius of the circular section [length], positive.",
                      non_negative());
    prm.add_parameter("youngs modulus",
                      youngs_modulus,
                      "Young's modulus [force/length^2], positive.",
                      non_negative());
    prm.add_parameter("poisson ratio",
                      poisson_ratio,
                      "Poisson's ratio. A shear-rigid fiber without torsion "
                      "does not depend on it.",
                      Patterns::Double());
    prm.add_parameter("cells",
                      n_cells,
                      "The number of equal cells along s.",
                      positive_integer());
    prm.add_parameter("number density",
                      number_density,
                      "Points of the interaction potential per volume "
                      "[1/length^3].",
                      non_negative());
    prm.add_parameter("surface density",
                      surface_density,
                      "Points of the interaction potential per area of the "
                      "lateral surface, or their charge, of either sign "
                      "[1/length^2].",
                      Patterns::Double());
    prm.add_parameter("density",
                      density,
                      "Mass per volume [mass/length^3], positive in a scene "
                      "with dynamics; statics does not use it.",
                      non_negative());
    prm.add_parameter("initial velocity",
                      initial_velocity,
                      "The velocity at time 0 in a scene with dynamics, "
                      "x; y; z, as formulas of the arc length s and of the "
                      "numbers i, j, k of the copy [length/time].",
                      Patterns::Anything());
    beam = TorsionFreeKirchhoff::name;
    prm.add_parameter("beam",
                      beam,
                      "The beam formulation. " + Beams::descriptions() + ".",
                      Patterns::Selection(Beams::names()));
  }



  void
  SupportParameters::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter("fibers",
                      fibers,
                      "The fibers that are supported, by name, or 'all'.",
                      names_pattern());
    prm.add_parameter("at",
                      at,
                      "Where: 'start', 'end', 'all' (every node) or an arc "
                      "length s at which there is a node [length].",
                      names_pattern());
    prm.add_parameter("displacement",
                      displacement,
                      "The displacement of the points from where they were "
                      "initially, x; y; z, each 'free' or a formula of the "
                      "time t and of the numbers i, j, k of the copy [length].",
                      Patterns::Anything());
    prm.add_parameter("tangent",
                      tangent,
                      "The change of the unit tangents from what they were "
                      "initially, x; y; z, each 'free' or a formula of t and "
                      "of i, j, k.",
                      Patterns::Anything());
  }



  void
  LoadParameters::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter("fibers",
                      fibers,
                      "The fibers that are loaded, by name, or 'all'.",
                      names_pattern());
    prm.add_parameter("at",
                      at,
                      "Where: 'start', 'end' or an arc length s for a point "
                      "load, 'all' for a line load.",
                      names_pattern());
    prm.add_parameter(
      "force",
      force,
      "A dead load x; y; z as formulas of s and t: a force at a "
      "point [force], or per initial length [force/length].",
      Patterns::Anything());
    prm.add_parameter("moment",
                      moment,
                      "A moment x; y; z about axes fixed in space, as formulas "
                      "of s and t, at a point [force length] or per initial "
                      "length [force]. Its part along the tangent does no work "
                      "on a fiber without torsion.",
                      Patterns::Anything());
  }



  void
  InteractionParameters::add_parameters(ParameterHandler &prm)
  {
    law = DiskCylinder::name;
    prm.add_parameter("law",
                      law,
                      "The reduced law. " + Laws::descriptions() + ".",
                      Patterns::Selection(Laws::names()));
    prm.add_parameter(
      "target ends",
      target_ends,
      "Beyond the end of a target: 'clamped' keeps the infinite "
      "cylinder at the last point (SBIP), too much by about a "
      "factor of two; 'finite' takes the part of the potential "
      "that the target contributes on this side of its end; "
      "'by law' is finite for laws that know the tilt of a "
      "section, which cannot be clamped.",
      Patterns::Selection("by law|clamped|finite"));
    prm.add_parameter("source",
                      source,
                      "The fibers that are integrated over (the papers' slave "
                      "side), by name, or 'all'. Two fibers that are both in "
                      "source and target interact once, the one listed first "
                      "being the source.",
                      names_pattern());
    prm.add_parameter("target",
                      target,
                      "The fibers that are projected onto (the papers' master "
                      "side), by name, or 'all'.",
                      names_pattern());
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
                      "which two parallel cylinders feel no force [length].",
                      non_negative());
    prm.add_parameter("force minimum",
                      force_minimum,
                      "Instead of prefactors, for Lennard-Jones: the most "
                      "attractive force per length of two parallel cylinders "
                      "[force/length], negative.",
                      Patterns::Double(-infinity, 0.));
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
                      "error, and keep them long elsewhere. 0 leaves all "
                      "segments equal.",
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



  void
  LoadSteppingParameters::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter("end time",
                      end_time,
                      "The load goes from time 0 to this one.",
                      non_negative());
    prm.add_parameter("first step",
                      first_step,
                      "The first load step [time].",
                      non_negative());
    prm.add_parameter("largest step",
                      largest_step,
                      "The largest load step [time], a formula of t: small "
                      "where a peak of the curve has to be resolved.",
                      Patterns::Anything());
    prm.add_parameter("smallest step",
                      smallest_step,
                      "A step that cannot be solved is repeated with smaller "
                      "size down to this one [time].",
                      non_negative());
    prm.add_parameter("growth",
                      growth,
                      "Largest factor from one step to the next.",
                      Patterns::Double(1.));
    prm.add_parameter("target iterations",
                      target_n_iterations,
                      "A step that takes more iterations than this one is "
                      "followed by a smaller one.",
                      positive_integer());
    prm.add_parameter("pass instabilities",
                      pass_instabilities,
                      "Where no equilibrium is found with the smallest step, "
                      "follow the overdamped motion to the next stable state "
                      "instead of stopping.");
  }



  void
  NewtonParameters::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter("residual tolerance",
                      residual_tolerance,
                      "Largest Euclidean norm of the residual [force]; where "
                      "round-off of stiff fibers leaves more, that counts.",
                      non_negative());
    prm.add_parameter("increment tolerance",
                      increment_tolerance,
                      "Largest Euclidean norm of the last increment.",
                      non_negative());
    prm.add_parameter("iterations",
                      max_n_iterations,
                      "Largest number of iterations of one load step.",
                      positive_integer());
    prm.add_parameter("largest increment",
                      largest_increment,
                      "Largest displacement of a node by one correction "
                      "[length]; 0 means no bound.",
                      non_negative());
    prm.add_parameter("linear solver",
                      linear_solver,
                      "The direct solver of Trilinos' Amesos.",
                      Patterns::Selection("Amesos_Klu|Amesos_Mumps"));
    prm.add_parameter("log iterations",
                      log_iterations,
                      "Print a line for every iteration.");
  }



  void
  OutputParameters::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter("directory",
                      directory,
                      "Where results are written; empty takes 'output-' and "
                      "the name of the .prm file.",
                      Patterns::Anything());
    prm.add_parameter("fields",
                      fields,
                      "Write fibers and interaction forces for ParaView.");
    prm.add_parameter("interval",
                      interval,
                      "Time between two outputs of fields; 0 writes every load "
                      "step.",
                      non_negative());
    prm.add_parameter("subdivisions",
                      n_subdivisions,
                      "Lines that a cell is drawn with.",
                      positive_integer());
  }



  void
  FullQuadratureParameters::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter(
      "tolerance",
      tolerance,
      "Gauss points are added until the energy changes by less, "
      "relative to itself; positive.",
      non_negative());
    prm.add_parameter("separation",
                      separation,
                      "Cells are refined until all pairs of the two bodies are "
                      "apart by this multiple of their size; positive. Smaller "
                      "means less cells with more Gauss points.",
                      non_negative());
    prm.add_parameter(
      "gauss points",
      max_n_points,
      "At most so many in each direction of a cell, at least 3.",
      Patterns::Integer(3));
    prm.add_parameter("point pairs",
                      max_n_pairs,
                      "At most so many for two fibers; a core does about 1e9 "
                      "in a second.",
                      non_negative());
    prm.add_parameter("cells",
                      max_n_cells,
                      "At most about so many in the meshes of two fibers.",
                      non_negative());
  }
} // namespace Setae
