!> Approximate solve where oil is too viscous for pressure to move it: the film's mass is given, and pressure follows from it.
!>
!> Where an implicit time step along the oil's path rules the balance, rho h changes by deflection and compression alone, of
!> which the multigrid's model knows those under a node. `elastic_inverse` knows them at all distances, and one mobility: that
!> at which flow and deflection balance at the shortest waves of the grid. Nodes count for it the less, the more mobile their
!> oil is.
module pyworm_transported_film
  use pyworm_elastic_inverse, only: elastic_inverse, new_elastic_inverse, set_compression
  use pyworm_kinds, only: wp
  use pyworm_reynolds, only: film_fields
  use pyworm_status, only: status_ok, status_no_memory
  implicit none(type, external)
  private

  public :: film_transport, new_film_transport, set_film_transport, transported_pressure

  real(wp), parameter :: pi = acos(-1.0_wp)
  !> Mobility over that of the inverse at which nodes no longer count: 3000 took six to seven iterations in a step of a wave
  !> through a contact (M = 100, L = 10), 10 and 200 eight to ten.
  real(wp), parameter :: mobile_ratio = 3000

  type :: film_transport
    type(elastic_inverse) :: inverse
    !> Weight of a node, and film by outflow there [s]; both zero where pressure is not free.
    real(wp), allocatable :: weight(:, :), per_outflow(:, :)
    !> Scratch: pressure [Pa] and outflow [m/s].
    real(wp), allocatable :: p(:, :), rest(:, :)
  end type film_transport

contains

  !> Makes the approximate solve of a grid; `reduced_modulus` as of `new_half_space`.
  subroutine new_film_transport(self, nx, ny, spacing, reduced_modulus, stat)
    type(film_transport), intent(inout) :: self
    integer, intent(in) :: nx, ny
    real(wp), intent(in) :: spacing(2), reduced_modulus
    integer, intent(out) :: stat
    integer :: err

    call new_elastic_inverse(self%inverse, nx, ny, spacing(1), spacing(2), reduced_modulus, stat)
    if (stat /= status_ok) return
    allocate (self%weight(nx, ny), self%per_outflow(nx, ny), self%p(nx, ny), self%rest(nx, ny), source=0.0_wp, stat=err)
    if (err /= 0) stat = status_no_memory
  end subroutine new_film_transport

  !> Sets the weights at the fields of a film, free where pressure may change; `rate` [1/s] is that of the time step.
  subroutine set_film_transport(self, fields, free, rate, dx)
    type(film_transport), intent(inout) :: self
    type(film_fields), intent(in) :: fields
    logical, intent(in) :: free(:, :)
    real(wp), intent(in) :: rate, dx
    real(wp) :: balanced, compression, summed, mobile
    integer :: i, j

    balanced = 1/(self%inverse%stiffness*(pi/dx)**3)
    compression = 0
    summed = 0
    !$omp parallel do private(i, mobile) reduction(+:compression, summed) schedule(static)
    do j = 1, size(free, 2)
      do i = 1, size(free, 1)
        self%weight(i, j) = 0
        self%per_outflow(i, j) = 0
        if (.not. (free(i, j) .and. rate > 0)) cycle
        mobile = max(fields%mobility(i, j)/(rate*fields%rho(i, j)*balanced), 1.0_wp)
        if (.not. mobile < mobile_ratio) cycle
        self%weight(i, j) = sqrt(1 - log(mobile)/log(mobile_ratio))
        self%per_outflow(i, j) = self%weight(i, j)/(rate*fields%rho(i, j))
        compression = compression + self%weight(i, j)*max(fields%rho_p(i, j)*fields%h(i, j)/fields%rho(i, j), 0.0_wp)
        summed = summed + self%weight(i, j)
      end do
    end do
    call set_compression(self%inverse, compression/max(summed, tiny(summed)), balanced)
  end subroutine set_film_transport

  !> Computes the pressure p that takes away an outflow r [m/s] by deflection and compression, as far as these rule.
  subroutine transported_pressure(self, r)
    type(film_transport), intent(inout) :: self
    real(wp), contiguous, intent(in) :: r(:, :)
    integer :: j

    !$omp parallel do schedule(static)
    do j = 1, size(r, 2)
      self%rest(:, j) = r(:, j)*self%per_outflow(:, j)
    end do
    call self%inverse%pressure(self%rest, self%p)
    !$omp parallel do schedule(static)
    do j = 1, size(r, 2)
      self%p(:, j) = self%p(:, j)*self%weight(:, j)
    end do
  end subroutine transported_pressure

end module pyworm_transported_film
