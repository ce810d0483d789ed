!> A gap that oil fills only in part where its pressure is ambient: oil is carried on there and neither made nor lost.
!>
!> Of the gap a fraction theta is filled, with p >= 0, theta <= 1, p (1 - theta) = 0 (Jakobsson and Floberg 1957, Olsson 1965;
!> Elrod, J. Lubr. Technol. 103 (1981) 350). The wedge's flow through a face is that of a full gap times the fraction of the
!> node that it comes from, so that a node's balance changes continuously where it fills or ruptures. At given pressures
!> fractions follow from node to node along the flow: they are no unknowns of Newton's method, but solved exactly by one pass
!> downstream, in the residual as in the Jacobian (its Schur complement).
!>
!> Oil enters through the outline and from nodes where a surface ends, at most as the layer that is supplied there. Fields
!> have shape (nx, ny), with ny = 1 of a line contact; here they are one sequence of nodes.
module pyworm_partial_film
  use pyworm_kinds, only: wp
  use pyworm_status, only: status_ok, status_bad_argument, status_no_memory, status_not_finite
  implicit none(type, external)
  private

  public :: partial_film, new_partial_film, fill_gap, carry_change, feed_downstream

  type :: partial_film
    integer :: nx = 0, ny = 0
    !> Weights of rho h in the wedge's flow through a face: of the second node upstream, of the first, and of that downstream.
    real(wp) :: weights(3) = 0
    !> Entrainment through the face after a node, over the spacing, along x and y [1/s].
    real(wp), allocatable :: rate_x(:), rate_y(:)
    !> Thickness of the oil that is supplied where it enters [m].
    real(wp), allocatable :: supply(:)
    !> Fraction of the gap that is filled.
    real(wp), allocatable :: fraction(:)
    !> rho h of the full gap and a change of it [m], set by the caller.
    real(wp), allocatable :: mass(:, :), mass_change(:, :)
    !> Wedge flow through the face after a node, over the spacing, as if the gap were full [m/s]; the share of it that flows; the
    !> share of its changes, zero where the supply limits it.
    real(wp), allocatable :: full_x(:), full_y(:), share_x(:), share_y(:), follow_x(:), follow_y(:)
    !> Nodes at ambient pressure, each after those that feed it, and their number.
    integer, allocatable :: order(:)
    integer :: ambient = 0
    !> Scratch: number of nodes that are still to come before a node; a flow through the faces.
    integer, allocatable :: awaited(:)
    real(wp), allocatable :: through_x(:), through_y(:)
  end type partial_film

contains

  !> Makes a gap of nx by ny nodes with a supply of oil; the other arguments as of the type.
  subroutine new_partial_film(nx, ny, supply, weights, rate_x, rate_y, self, stat)
    integer, intent(in) :: nx, ny
    real(wp), intent(in) :: supply(nx*ny), weights(3), rate_x(nx*ny), rate_y(nx*ny)
    type(partial_film), intent(out) :: self
    integer, intent(out) :: stat
    integer :: n, err

    stat = status_not_finite
    if (.not. all(supply <= huge(1.0_wp))) return
    stat = status_bad_argument
    if (.not. all(supply >= 0)) return
    n = nx*ny
    self%nx = nx
    self%ny = ny
    self%weights = weights
    allocate (self%rate_x(n), self%rate_y(n), self%supply(n), self%fraction(n), self%full_x(n), self%full_y(n), &
      self%share_x(n), self%share_y(n), self%follow_x(n), self%follow_y(n), self%through_x(n), self%through_y(n), &
      self%mass(nx, ny), self%mass_change(nx, ny), source=0.0_wp, stat=err)
    if (err == 0) allocate (self%order(n), self%awaited(n), source=0, stat=err)
    stat = merge(status_ok, status_no_memory, err == 0)
    if (stat /= status_ok) return
    self%rate_x = rate_x
    self%rate_y = rate_y
    self%supply = supply
  end subroutine new_partial_film

  !> Fills the gap at its `mass` and at pressure p [Pa]; adds the wedge's and the transient flow to r [m/s], which holds the rest
  !> of the net outflow.
  !>
  !> Nodes without pressure whose gap is not full balance exactly; those that get more oil than a full gap passes on are full
  !> and keep a negative net outflow.
  subroutine fill_gap(self, covered, p, implicit_rate, r)
    type(partial_film), intent(inout) :: self
    logical, contiguous, intent(in) :: covered(:, :)
    real(wp), contiguous, intent(in) :: p(:, :)
    real(wp), intent(in) :: implicit_rate
    real(wp), contiguous, intent(inout) :: r(:, :)

    call fill_nodes(self, size(p), covered, p, implicit_rate, r)
  end subroutine fill_gap

  !> Adds to `change`, the change of the net outflow by pressure [m/s], that by the `mass_change` of the full gap, and what
  !> the change of the fractions makes of both.
  subroutine carry_change(self, implicit_rate, change)
    type(partial_film), intent(inout) :: self
    real(wp), intent(in) :: implicit_rate
    real(wp), contiguous, intent(inout) :: change(:, :)

    call set_flows(self, size(change), self%mass_change, self%through_x, self%through_y)
    self%through_x = self%follow_x*self%through_x
    self%through_y = self%follow_y*self%through_y
    call add_flow(self, size(change), self%through_x, self%through_y, change)
    call add_storage(self, size(change), implicit_rate, self%mass_change, change)
    call feed_downstream(self, implicit_rate, change)
  end subroutine carry_change

  !> Lets fractions change such that nodes whose gap is not full stay in balance, and adds what they then pass on to the `change`
  !> of the net outflow [m/s].
  subroutine feed_downstream(self, implicit_rate, change)
    type(partial_film), intent(inout) :: self
    real(wp), intent(in) :: implicit_rate
    real(wp), contiguous, intent(inout) :: change(:, :)

    call feed_nodes(self, size(change), implicit_rate, self%mass, change)
  end subroutine feed_downstream

  subroutine fill_nodes(self, n, covered, p, implicit_rate, r)
    type(partial_film), intent(inout) :: self
    integer, intent(in) :: n
    logical, intent(in) :: covered(n)
    real(wp), intent(in) :: p(n), implicit_rate
    real(wp), intent(inout) :: r(n)
    integer :: k, node

    call set_flows(self, n, self%mass, self%full_x, self%full_y)
    call start_fractions(self, n, p, self%mass)
    call share_faces(self, n, .not. (covered .or. p > 0))
    call order_downstream(self, n, covered .and. .not. p > 0)
    do k = 1, self%ambient
      node = self%order(k)
      self%fraction(node) = filled(self, n, node, r(node), implicit_rate, self%mass)
      call share_outflow(self, node)
    end do
    self%through_x = self%share_x*self%full_x
    self%through_y = self%share_y*self%full_y
    call add_flow(self, n, self%through_x, self%through_y, r)
    call add_storage(self, n, implicit_rate, self%mass, r)
    where (self%fraction < 1 .or. .not. covered) r = 0
  end subroutine fill_nodes

  !> Sets fractions to full where there is pressure, elsewhere to those of the layer that is supplied.
  pure subroutine start_fractions(self, n, p, mass)
    type(partial_film), intent(inout) :: self
    integer, intent(in) :: n
    real(wp), intent(in) :: p(n), mass(n)

    self%fraction = 1
    where (.not. p > 0) self%fraction = min(1.0_wp, self%supply/max(mass, tiny(1.0_wp)))
  end subroutine start_fractions

  subroutine feed_nodes(self, n, implicit_rate, mass, change)
    type(partial_film), intent(in) :: self
    integer, intent(in) :: n
    real(wp), intent(in) :: implicit_rate, mass(n)
    real(wp), intent(inout) :: change(n)
    real(wp) :: leaving(4), fraction_change
    integer :: k, side, node, to(4)

    do k = 1, self%ambient
      node = self%order(k)
      if (.not. (self%fraction(node) > 0 .and. self%fraction(node) < 1)) cycle
      call outflows(self, node, leaving, to)
      leaving = max(leaving, 0.0_wp)
      ! the node's balance is kept: what its fraction passes on and stores takes up the change
      fraction_change = -change(node)/(sum(leaving) + implicit_rate*mass(node))
      do side = 1, sides(self)
        change(to(side)) = change(to(side)) - leaving(side)*fraction_change
      end do
      change(node) = 0
    end do
  end subroutine feed_nodes

  !> Adds the implicit part of the transient term at a mass.
  pure subroutine add_storage(self, n, implicit_rate, mass, r)
    type(partial_film), intent(in) :: self
    integer, intent(in) :: n
    real(wp), intent(in) :: implicit_rate, mass(n)
    real(wp), intent(inout) :: r(n)

    r = r + implicit_rate*self%fraction*mass
  end subroutine add_storage

  !> Computes the wedge's flow of q through the faces, over the spacing; next to the outline q is the mean of a face's two nodes.
  subroutine set_flows(self, n, q, along_x, along_y)
    type(partial_film), intent(in) :: self
    integer, intent(in) :: n
    real(wp), intent(in) :: q(n)
    real(wp), intent(inout) :: along_x(n), along_y(n)
    integer :: i, j, node

    !$omp parallel do private(i, node) schedule(static)
    do j = first_row(self), last_row(self)
      do i = 1, self%nx - 1
        node = i + self%nx*(j - 1)
        if (i == 1 .or. i == self%nx - 1) then
          along_x(node) = self%rate_x(node)*(q(node) + q(node + 1))/2
        else
          along_x(node) = upwind(self%weights, self%rate_x(node), q(node - 1), q(node), q(node + 1), q(node + 2))
        end if
      end do
    end do
    associate (next => self%nx)
      !$omp parallel do private(i, node) schedule(static)
      do j = 1, self%ny - 1
        do i = 2, self%nx - 1
          node = i + next*(j - 1)
          if (j == 1 .or. j == self%ny - 1) then
            along_y(node) = self%rate_y(node)*(q(node) + q(node + next))/2
          else
            along_y(node) = upwind(self%weights, self%rate_y(node), q(node - next), q(node), q(node + next), q(node + 2*next))
          end if
        end do
      end do
    end associate
  end subroutine set_flows

  !> Flow of q through a face between the second and the third of four nodes.
  pure real(wp) function upwind(weights, rate, q1, q2, q3, q4)
    real(wp), intent(in) :: weights(3), rate, q1, q2, q3, q4

    upwind = max(rate, 0.0_wp)*(weights(1)*q1 + weights(2)*q2 + weights(3)*q3) &
      + min(rate, 0.0_wp)*(weights(1)*q4 + weights(2)*q3 + weights(3)*q2)
  end function upwind

  !> Sets the shares of all faces from the fractions, and limits the flow from nodes that are `outside` to the layer supplied.
  subroutine share_faces(self, n, outside)
    type(partial_film), intent(inout) :: self
    integer, intent(in) :: n
    logical, intent(in) :: outside(n)
    integer :: i, j, node

    do j = first_row(self), last_row(self)
      do i = 1, self%nx - 1
        node = i + self%nx*(j - 1)
        call share(node + merge(0, 1, self%full_x(node) > 0), self%rate_x(node), self%full_x(node), self%share_x(node), &
          self%follow_x(node))
      end do
    end do
    do j = 1, self%ny - 1
      do i = 2, self%nx - 1
        node = i + self%nx*(j - 1)
        call share(node + merge(0, self%nx, self%full_y(node) > 0), self%rate_y(node), self%full_y(node), self%share_y(node), &
          self%follow_y(node))
      end do
    end do

  contains

    pure subroutine share(from, rate, full, part, follow)
      integer, intent(in) :: from
      real(wp), intent(in) :: rate
      real(wp), intent(inout) :: full
      real(wp), intent(out) :: part, follow

      part = merge(1.0_wp, self%fraction(from), outside(from))
      follow = part
      if (.not. outside(from) .or. abs(full) <= abs(rate)*self%supply(from)) return
      full = sign(rate*self%supply(from), full)
      follow = 0
    end subroutine share

  end subroutine share_faces

  !> Sets the shares of the faces through which oil leaves a node.
  pure subroutine share_outflow(self, node)
    type(partial_film), intent(inout) :: self
    integer, intent(in) :: node

    associate (x => self%full_x, y => self%full_y, nx => self%nx, fraction => self%fraction(node))
      if (x(node) > 0) call set(self%share_x(node), self%follow_x(node))
      if (.not. x(node - 1) > 0) call set(self%share_x(node - 1), self%follow_x(node - 1))
      if (self%ny == 1) return
      if (y(node) > 0) call set(self%share_y(node), self%follow_y(node))
      if (.not. y(node - nx) > 0) call set(self%share_y(node - nx), self%follow_y(node - nx))
    end associate

  contains

    pure subroutine set(part, follow)
      real(wp), intent(out) :: part, follow

      part = self%fraction(node)
      follow = part
    end subroutine set

  end subroutine share_outflow

  !> Sets the order of the inner nodes that are `ambient`, each after those that feed it.
  !>
  !> Of a closed stream one node comes before one that feeds it, which counts as holding the layer that is supplied.
  subroutine order_downstream(self, n, ambient)
    type(partial_film), intent(inout) :: self
    integer, intent(in) :: n
    logical, intent(in) :: ambient(n)
    real(wp) :: leaving(4)
    integer :: i, j, node, side, seen, found, to(4)

    self%awaited = -1
    found = 0
    do j = first_row(self), last_row(self)
      do i = 2, self%nx - 1
        node = i + self%nx*(j - 1)
        if (.not. ambient(node)) cycle
        call outflows(self, node, leaving, to)
        self%awaited(node) = count(leaving(:sides(self)) < 0 .and. ambient(to(:sides(self))))
        if (self%awaited(node) == 0) call append(node)
      end do
    end do
    seen = 0
    do node = 1, n
      do while (seen < found)
        seen = seen + 1
        call outflows(self, self%order(seen), leaving, to)
        do side = 1, sides(self)
          if (leaving(side) > 0) call come_before(to(side))
        end do
      end do
      ! a closed stream
      if (self%awaited(node) > 0) call append(node)
    end do
    self%ambient = found

  contains

    subroutine append(node)
      integer, intent(in) :: node

      self%awaited(node) = 0
      found = found + 1
      self%order(found) = node
    end subroutine append

    !> Counts a node that comes before another.
    subroutine come_before(node)
      integer, intent(in) :: node

      if (self%awaited(node) < 1) return
      self%awaited(node) = self%awaited(node) - 1
      if (self%awaited(node) == 0) call append(node)
    end subroutine come_before

  end subroutine order_downstream

  !> Fraction of a node's gap that is filled by its inflow, the rest of its net outflow being r [m/s].
  pure real(wp) function filled(self, n, node, r, implicit_rate, mass)
    type(partial_film), intent(in) :: self
    integer, intent(in) :: n, node
    real(wp), intent(in) :: r, implicit_rate, mass(n)
    real(wp) :: leaving(4), inflow, outflow
    integer :: to(4)

    call outflows(self, node, leaving, to)
    inflow = self%share_x(node - 1)*max(-leaving(2), 0.0_wp) + self%share_x(node)*max(-leaving(1), 0.0_wp) - r
    if (self%ny > 1) inflow = inflow + self%share_y(node)*max(-leaving(3), 0.0_wp) &
      + self%share_y(node - self%nx)*max(-leaving(4), 0.0_wp)
    outflow = sum(max(leaving, 0.0_wp)) + implicit_rate*mass(node)
    filled = 1
    if (inflow < outflow) filled = max(inflow/outflow, 0.0_wp)
  end function filled

  !> Wedge flow out of an inner node through its faces as if the gap were full [m/s], and the nodes it leaves to.
  pure subroutine outflows(self, node, leaving, to)
    type(partial_film), intent(in) :: self
    integer, intent(in) :: node
    real(wp), intent(out) :: leaving(4)
    integer, intent(out) :: to(4)

    leaving(1:2) = [self%full_x(node), -self%full_x(node - 1)]
    leaving(3:4) = 0
    if (self%ny > 1) leaving(3:4) = [self%full_y(node), -self%full_y(node - self%nx)]
    to = node + [1, -1, self%nx, -self%nx]
  end subroutine outflows

  !> Adds the net outflow of the inner nodes by a flow through the faces after the nodes, over the spacing.
  subroutine add_flow(self, n, along_x, along_y, r)
    type(partial_film), intent(in) :: self
    integer, intent(in) :: n
    real(wp), intent(in) :: along_x(n), along_y(n)
    real(wp), intent(inout) :: r(n)
    integer :: i, j, node

    do j = first_row(self), last_row(self)
      do i = 2, self%nx - 1
        node = i + self%nx*(j - 1)
        r(node) = r(node) + along_x(node) - along_x(node - 1)
        if (self%ny > 1) r(node) = r(node) + along_y(node) - along_y(node - self%nx)
      end do
    end do
  end subroutine add_flow

  !> First row of inner nodes.
  pure integer function first_row(self)
    type(partial_film), intent(in) :: self

    first_row = min(2, self%ny)
  end function first_row

  !> Last row of inner nodes.
  pure integer function last_row(self)
    type(partial_film), intent(in) :: self

    last_row = max(self%ny - 1, 1)
  end function last_row

  !> Number of faces of a node's cell.
  pure integer function sides(self)
    type(partial_film), intent(in) :: self

    sides = merge(2, 4, self%ny == 1)
  end function sides

end module pyworm_partial_film
