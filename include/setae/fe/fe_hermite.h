// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_fe_fe_hermite_h
#define setae_fe_fe_hermite_h

#include <deal.II/fe/fe_poly.h>

#include <memory>
#include <string>

namespace Setae
{
  /**
   * The cubic Hermite element on the straight cells of a curve in space: two
   * degrees of freedom per vertex, the value @f$u@f$ of the field and its
   * derivative @f$u_{,l}@f$ with respect to the length @f$l@f$ along the chord
   * between the two vertices of the cell. With the coordinate @f$x\in[0,1]@f$
   * of the unit cell and the length @f$h@f$ of the chord [length] it
   * interpolates as Hermite::shape_values(),
   * @f[
   *   u(x) = N_1(x)\,u_1 + N_2(x,h)\,u_{1,l} + N_3(x)\,u_2 + N_4(x,h)\,u_{2,l},
   * @f]
   * with the local degrees of freedom in this order. Since the vertex owns the
   * derivative, @f$u_{,x}/h@f$ is continuous from cell to cell also where
   * their lengths differ, and so is the tangent of a centerline whose three
   * coordinates are such fields.
   *
   * In an FESystem of this element, <code>[c, a] =
   * fe.system_to_component_index(i)</code> gives for the local degree of
   * freedom @p i the component @p c and the number @p a of the shape function
   * in the formula above, both counted from zero.
   *
   * <h3>What FEValues returns</h3>
   * Values and derivatives up to the third with the factor @f$h@f$ of
   * @f$N_2@f$ and @f$N_4@f$. In codimension the derivatives are tensors along
   * the unit vector @f$e@f$ of the chord: the gradient of @f$u@f$ is
   * @f$u_{,l}\,e@f$, its Hessian @f$u_{,ll}\,e\otimes e@f$. On a polygon
   * @f$e@f$ turns from cell to cell; it is @f$u_{,l}@f$, the gradient times
   * @f$e@f$, that does not jump. All this assumes the default mapping of degree
   * one; a curved mapping has another measure of length.
   *
   * <h3>Arc length</h3>
   * The vertices lie on the centerline and @f$h@f$ is the chord, shorter than
   * the arc in between. Interpolated from positions and unit tangents, a
   * centerline @f$r_h(x)@f$ is as a curve accurate to fourth order, but its
   * arc length is not proportional to @f$x@f$ within the cell: against
   * @f$r(s_1 + x(s_2-s_1))@f$ the error is of third order, by a slip along the
   * tangent. Fields over the arc length, @f$s@f$ itself among them, slip with
   * it when they are interpolated by this element; compared at the same
   * @f$s@f$ all is of fourth order.
   *
   * <h3>What it cannot do</h3>
   * - There are neither support points nor generalized ones, because point
   *   values do not determine the derivatives: VectorTools::interpolate() and
   *   the functions built on it fail. Set the degrees of freedom or use
   *   VectorTools::project().
   * - There are no prolongation and restriction matrices, because they would
   *   depend on @f$h@f$: a solution cannot be transferred between meshes.
   * - The functions on the unit cell, shape_value() and its derivatives, know
   *   no cell and take @f$h=1@f$. Whatever is built on them instead of
   *   FEValues, such as MappingFEField, is wrong for this element.
   */
  template <int dim, int spacedim = dim>
  class FE_Hermite : public dealii::FE_Poly<dim, spacedim>
  {
    static_assert(dim == 1, "This Hermite element is one for curves.");

  public:
    using CellIterator =
      typename dealii::Triangulation<dim, spacedim>::cell_iterator;

    FE_Hermite();

    /**
     * The length @f$h@f$ of the chord of @p cell [length], which turns the
     * derivative degrees of freedom into derivatives on the unit cell. Every
     * evaluation that does without FEValues has to use it.
     */
    static double
    length_scale(const CellIterator &cell);

    std::string
    get_name() const override;

    std::unique_ptr<dealii::FiniteElement<dim, spacedim>>
    clone() const override;

  protected:
    using MappingInternal =
      typename dealii::Mapping<dim, spacedim>::InternalDataBase;
    using ElementInternal =
      typename dealii::FiniteElement<dim, spacedim>::InternalDataBase;
    using MappingOutput =
      dealii::internal::FEValuesImplementation::MappingRelatedData<dim,
                                                                   spacedim>;
    using ElementOutput = dealii::internal::FEValuesImplementation::
      FiniteElementRelatedData<dim, spacedim>;

    std::unique_ptr<ElementInternal>
    get_data(const dealii::UpdateFlags             update_flags,
             const dealii::Mapping<dim, spacedim> &mapping,
             const dealii::Quadrature<dim>        &quadrature,
             ElementOutput                        &output) const override;

    void
    fill_fe_values(const CellIterator                      &cell,
                   const dealii::CellSimilarity::Similarity cell_similarity,
                   const dealii::Quadrature<dim>           &quadrature,
                   const dealii::Mapping<dim, spacedim>    &mapping,
                   const MappingInternal                   &mapping_internal,
                   const MappingOutput                     &mapping_output,
                   const ElementInternal                   &element_internal,
                   ElementOutput &output) const override;

    using dealii::FE_Poly<dim, spacedim>::fill_fe_face_values;

    void
    fill_fe_face_values(const CellIterator                     &cell,
                        const unsigned int                      face_no,
                        const dealii::hp::QCollection<dim - 1> &quadrature,
                        const dealii::Mapping<dim, spacedim>   &mapping,
                        const MappingInternal &mapping_internal,
                        const MappingOutput   &mapping_output,
                        const ElementInternal &element_internal,
                        ElementOutput         &output) const override;
  };
} // namespace Setae

#endif
