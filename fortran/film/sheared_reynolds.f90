!> Reynolds' equation of a sheared film: any flow law, and a viscosity that varies across the film.
!>
!>     div(rho h um) - div(rho S) + d(rho h)/dt = 0,   S = int z F(tau)/tau (tau_x, tau_y) dz
!>
!> (Sharif et al. 2001, eqs 10 and 11, in x and y instead of the frame of sliding). S is taken at the faces between
!> nodes, with its exact derivatives by the pressure gradient (a full tensor), pressure and film. Fluidities of a
!> face's two nodes are averaged with weights rho h**3, so that for an isothermal Newtonian oil the scheme is that
!> of `reynolds` to rounding.
!>
!> Between rough surfaces the oil shears over the mean thickness of the gap; the pressure flow factors multiply S, and the
!> shear flow factors carry oil with the rougher wall (Patir and Cheng 1979, their tensors by the lay; see `rough_surfaces`).
module pyworm_sheared_reynolds
  use pyworm_gauss_lobatto, only: levels_across, new_levels
  use pyworm_flow_laws, only: flow_law, hardens, stress_scales
  use pyworm_kinds, only: wp
  use omp_lib, only: omp_get_max_threads, omp_get_thread_num
  use pyworm_viscosity_density, only: oil_law, hot_fluidity, hot_density
  use pyworm_reynolds, only: arithmetic_share, film_grid, film_fields, set_mass_change, add_wedge
  use pyworm_rough_surfaces, only: rough_film
  use pyworm_shear_flow, only: flow_change, flow_change_by_stresses
  use pyworm_shear_stress, only: solve_shear
  use pyworm_strip_of_points, only: shear_strip, new_shear_strip
  use pyworm_status, only: status_ok, status_no_memory
  implicit none(type, external)
  private

  public :: sheared_film, face_flow, new_sheared_film, set_sheared_fields, sheared_imbalance, sheared_imbalance_change
  public :: sheared_oil, set_oil, flow_through, still_ambient_faces

  !> Faces treated together: enough for vectors, few enough to stay in the first cache.
  integer, parameter, public :: strip = 64

  !> Flow rho S through the faces after the nodes in one direction, along their normal [m2/s], linearised.
  type :: face_flow
    !> Stress at the middle of the film [Pa], the initial guess of the next evaluation.
    real(wp), allocatable :: stress_x(:, :), stress_y(:, :)
    real(wp), allocatable :: flow(:, :)
    !> Change of the flow by that of the pressure gradient through the face, without sign [m3 s/kg].
    real(wp), allocatable :: mobility(:, :)
    !> Derivatives by the pressure of the node before and after, by the pressure gradient along the face, and by
    !> the film before and after, of rough surfaces by the gap between mean planes.
    real(wp), allocatable :: before(:, :), after(:, :), aside(:, :), film_before(:, :), film_after(:, :)
  end type face_flow

  !> The oil at the nodes.
  type :: sheared_oil
    type(flow_law) :: law
    type(levels_across) :: levels
    !> Share of the arithmetic mean of the nodes' mobilities in that of a face, the rest being the geometric mean.
    real(wp) :: arithmetic = arithmetic_share
    !> Velocity of body 2 relative to body 1 at the nodes [m/s].
    real(wp), allocatable :: sliding_x(:, :), sliding_y(:, :)
    !> Temperature at the levels less that of the inlet [K], third index.
    real(wp), allocatable :: rise(:, :, :)
    !> Fluidity 1/eta at the levels [1/(Pa s)] and its logarithmic derivative by pressure [1/Pa].
    real(wp), allocatable :: fluidity(:, :, :), fluidity_p(:, :, :)
    !> Stress at which the law departs from Newton's and limiting stress [Pa], and their derivatives by pressure.
    real(wp), allocatable :: onset(:, :), onset_p(:, :), limit(:, :), limit_p(:, :)
  end type sheared_oil

  type :: sheared_film
    type(sheared_oil) :: nodes
    type(face_flow) :: along_x, along_y
    !> Scratch: rho h, or its change.
    real(wp), allocatable :: mass(:, :)
    !> One strip of faces for each thread.
    type(shear_strip), allocatable :: strips(:)
  end type sheared_film

contains

  !> Makes a film at its inlet temperature; `sliding` is the velocity of body 2 relative to body 1 at the nodes [m/s].
  subroutine new_sheared_film(law, levels, sliding_x, sliding_y, self, stat)
    type(flow_law), intent(in) :: law
    integer, intent(in) :: levels
    real(wp), intent(in) :: sliding_x(:, :), sliding_y(:, :)
    type(sheared_film), intent(out) :: self
    integer, intent(out) :: stat
    integer :: nx, ny, thread, err

    nx = size(sliding_x, 1)
    ny = size(sliding_x, 2)
    self%nodes%law = law
    self%nodes%levels = new_levels(levels)
    self%nodes%sliding_x = sliding_x
    self%nodes%sliding_y = sliding_y
    associate (nodes => self%nodes)
      allocate (nodes%rise(nx, ny, levels), nodes%fluidity(nx, ny, levels), nodes%fluidity_p(nx, ny, levels), &
        nodes%onset(nx, ny), nodes%onset_p(nx, ny), nodes%limit(nx, ny), nodes%limit_p(nx, ny), self%mass(nx, ny), &
        source=0.0_wp, stat=err)
    end associate
    stat = merge(status_ok, status_no_memory, err == 0)
    if (stat == status_ok) call new_face_flow(nx, ny, self%along_x, stat)
    if (stat == status_ok) call new_face_flow(nx, ny, self%along_y, stat)
    allocate (self%strips(0:omp_get_max_threads() - 1))
    do thread = 0, ubound(self%strips, 1)
      if (stat == status_ok) call new_shear_strip(strip, levels, self%strips(thread), stat)
    end do
  end subroutine new_sheared_film

  subroutine new_face_flow(nx, ny, faces, stat)
    integer, intent(in) :: nx, ny
    type(face_flow), intent(out) :: faces
    integer, intent(out) :: stat
    integer :: err

    allocate (faces%stress_x(nx, ny), faces%stress_y(nx, ny), faces%flow(nx, ny), &
      faces%mobility(nx, ny), faces%before(nx, ny), faces%after(nx, ny), faces%aside(nx, ny), &
      faces%film_before(nx, ny), faces%film_after(nx, ny), &
      source=0.0_wp, stat=err)
    stat = merge(status_ok, status_no_memory, err == 0)
  end subroutine new_face_flow

  !> Evaluates fields and face flows at the pressure and film of `fields`.
  !>
  !> `fields` gets the density. A film below `floor` [m] is replaced by the floor.
  subroutine set_sheared_fields(grid, oil, floor, film, fields)
    type(film_grid), intent(in) :: grid
    type(oil_law), intent(in) :: oil
    real(wp), intent(in) :: floor
    type(sheared_film), intent(inout) :: film
    type(film_fields), intent(inout) :: fields
    integer :: j

    film%strips%unsolved = 0
    !$omp parallel do schedule(static)
    do j = 1, grid%ny
      call set_oil(oil, 1, grid%nx, j, film%nodes, fields)
    end do
    !$omp parallel do schedule(dynamic, 4)
    do j = 1, grid%ny
      if (j > 1 .and. j < grid%ny) call flow_within_row(grid, floor, j, fields, film)
      if (j < grid%ny) call flow_between_rows(grid, floor, j, fields, film)
    end do
  end subroutine set_sheared_fields

  !> Evaluates the oil at the nodes first..last of row j.
  subroutine set_oil(oil, first, last, j, nodes, fields)
    type(oil_law), intent(in) :: oil
    integer, intent(in) :: first, last, j
    type(sheared_oil), intent(inout) :: nodes
    type(film_fields), intent(inout) :: fields
    real(wp) :: mean(first:last)
    real(wp), dimension(first:last, nodes%levels%count) :: rise, fluidity, by_pressure, by_temperature
    integer :: k

    rise = nodes%rise(first:last, j, :)
    associate (p => fields%p(first:last, j))
      call hot_fluidity(oil, p, rise, fluidity, by_pressure, by_temperature)
      mean = 0
      do k = 1, nodes%levels%count
        mean = mean + nodes%levels%weight(k)*rise(:, k)
        nodes%fluidity(first:last, j, k) = fluidity(:, k)
        nodes%fluidity_p(first:last, j, k) = by_pressure(:, k)
      end do
      call hot_density(oil, p, mean, fields%rho(first:last, j), fields%rho_p(first:last, j))
      call stress_scales(nodes%law, p, mean, nodes%onset(first:last, j), nodes%onset_p(first:last, j), &
        nodes%limit(first:last, j), nodes%limit_p(first:last, j))
    end associate
  end subroutine set_oil

  !> Evaluates the faces of row j, from each node to the next.
  subroutine flow_within_row(grid, floor, j, fields, film)
    type(film_grid), intent(in) :: grid
    real(wp), intent(in) :: floor
    integer, intent(in) :: j
    type(film_fields), intent(in) :: fields
    type(sheared_film), intent(inout) :: film
    real(wp) :: normal(strip), aside(strip)
    integer :: first, last, i

    do first = 1, grid%nx - 1, strip
      last = min(first + strip - 1, grid%nx - 1)
      associate (p => fields%p)
        do i = first, last
          normal(i - first + 1) = (p(i + 1, j) - p(i, j))/grid%dx
          aside(i - first + 1) = (p(i, j + 1) - p(i, j - 1) + p(i + 1, j + 1) - p(i + 1, j - 1))/(4*grid%dy)
        end do
      end associate
      call flow_through(film%nodes, fields, floor, first, last, j, 1, 0, 1/grid%dx, normal, aside, &
        film%strips(omp_get_thread_num()), film%along_x)
    end do
  end subroutine flow_within_row

  !> Evaluates the faces from the nodes of row j to those of the next.
  subroutine flow_between_rows(grid, floor, j, fields, film)
    type(film_grid), intent(in) :: grid
    real(wp), intent(in) :: floor
    integer, intent(in) :: j
    type(film_fields), intent(in) :: fields
    type(sheared_film), intent(inout) :: film
    real(wp) :: normal(strip), aside(strip)
    integer :: first, last, i

    do first = 2, grid%nx - 1, strip
      last = min(first + strip - 1, grid%nx - 1)
      associate (p => fields%p)
        do i = first, last
          normal(i - first + 1) = (p(i, j + 1) - p(i, j))/grid%dy
          aside(i - first + 1) = (p(i + 1, j) - p(i - 1, j) + p(i + 1, j + 1) - p(i - 1, j + 1))/(4*grid%dx)
        end do
      end associate
      call flow_through(film%nodes, fields, floor, first, last, j, 0, 1, 1/grid%dy, normal, aside, &
        film%strips(omp_get_thread_num()), film%along_y)
    end do
  end subroutine flow_between_rows

  !> Computes the linearised flow through the faces between nodes first..last of row j and those (di, dj) further on.
  !>
  !> `normal` and `aside` are the pressure gradient through the faces and along them [Pa/m].
  subroutine flow_through(nodes, fields, floor, first, last, j, di, dj, per_length, normal, aside, work, faces)
    type(sheared_oil), intent(in) :: nodes
    type(film_fields), intent(in) :: fields
    real(wp), intent(in) :: floor
    integer, intent(in) :: first, last, j, di, dj
    real(wp), intent(in) :: per_length, normal(strip), aside(strip)
    type(shear_strip), intent(inout) :: work
    type(face_flow), intent(inout) :: faces
    real(wp), dimension(strip) :: h1, h2, mass1, mass2, weight, rho, by_weight, by_fluidity1, by_fluidity2
    !> Changes by the gap at either node: of the film, of the logarithm of its mass, and of the flow aside that is turned.
    real(wp), dimension(strip) :: widening1, widening2, growth1, growth2, turn1, turn2, turned
    !> Geometric means of the nodes' fluidities at the levels, and their weight from those of the nodes.
    real(wp) :: geometric(strip, nodes%levels%count), by_geometric(strip)
    real(wp), dimension(strip) :: s_x, s_y, m_xx, m_xy, m_yy, h_x, h_y, onset_x, onset_y, limit_x, limit_y
    real(wp) :: by_mass1, by_mass2, by_p1, by_p2, by_h
    integer :: m, k, c, i, failures, normal_xx

    m = last - first + 1
    normal_xx = merge(1, 2, di == 1)
    work%points = m
    if (di == 1) then
      work%px(:m) = normal(:m)
      work%py(:m) = aside(:m)
    else
      work%px(:m) = aside(:m)
      work%py(:m) = normal(:m)
    end if
    associate (share => nodes%arithmetic, rho1 => fields%rho(first:last, j), rho2 => fields%rho(first + di:last + di, j + dj), &
        rho1_p => fields%rho_p(first:last, j), rho2_p => fields%rho_p(first + di:last + di, j + dj), &
        f1 => nodes%fluidity(first:last, j, :), f2 => nodes%fluidity(first + di:last + di, j + dj, :), h => work%film(:m), &
        f_x => work%level_x, f_y => work%level_y)
      h1(:m) = max(fields%h(first:last, j), floor)
      h2(:m) = max(fields%h(first + di:last + di, j + dj), floor)
      mass1(:m) = rho1*h1(:m)**3
      mass2(:m) = rho2*h2(:m)**3
      widening1(:m) = merge(1.0_wp, 0.0_wp, fields%h(first:last, j) > floor)
      widening2(:m) = merge(1.0_wp, 0.0_wp, fields%h(first + di:last + di, j + dj) > floor)
      growth1(:m) = 3*widening1(:m)/h1(:m)
      growth2(:m) = 3*widening2(:m)/h2(:m)
      if (allocated(fields%rough)) then
        call widen(fields%rough, first, last, j, normal_xx, mass1, widening1, growth1)
        call widen(fields%rough, first + di, last + di, j + dj, normal_xx, mass2, widening2, growth2)
      end if
      weight(:m) = mass1(:m)/(mass1(:m) + mass2(:m))
      h = (h1(:m) + h2(:m))/2
      rho(:m) = (mass1(:m) + mass2(:m))/(2*h**3)
      by_geometric(:m) = sqrt(weight(:m)*(1 - weight(:m)))
      do k = 1, nodes%levels%count
        geometric(:m, k) = 2*(1 - share)*sqrt(f1(:, k)*f2(:, k))
        work%fluidity(:m, k) = share*(weight(:m)*f1(:, k) + (1 - weight(:m))*f2(:, k)) &
          + by_geometric(:m)*geometric(:m, k)
      end do
      work%us(:m) = (nodes%sliding_x(first:last, j) + nodes%sliding_x(first + di:last + di, j + dj))/2
      work%vs(:m) = (nodes%sliding_y(first:last, j) + nodes%sliding_y(first + di:last + di, j + dj))/2
      work%reference(:m) = (nodes%onset(first:last, j) + nodes%onset(first + di:last + di, j + dj))/2
      work%limit(:m) = (nodes%limit(first:last, j) + nodes%limit(first + di:last + di, j + dj))/2
      work%tau_x(:m) = faces%stress_x(first:last, j)
      work%tau_y(:m) = faces%stress_y(first:last, j)
      call solve_shear(nodes%law, nodes%levels, work, failures)
      work%unsolved = work%unsolved + failures
      faces%stress_x(first:last, j) = work%tau_x(:m)
      faces%stress_y(first:last, j) = work%tau_y(:m)
      call flow_change(nodes%levels, work, s_x, s_y, m_xx, m_xy, m_yy, h_x, h_y, f_x, f_y)
      if (hardens(nodes%law)) then
        call flow_change_by_stresses(nodes%law, nodes%levels, work, onset_x, onset_y, limit_x, limit_y)
      else
        onset_x = 0
        onset_y = 0
        limit_x = 0
        limit_y = 0
      end if
      ! from here on x is through the face, y along it
      if (di == 0) then
        call swap(m, s_x, s_y)
        call swap(m, m_xx, m_yy)
        call swap(m, h_x, h_y)
        call swap(m, onset_x, onset_y)
        call swap(m, limit_x, limit_y)
        do k = 1, nodes%levels%count
          call swap(m, f_x(:, k), f_y(:, k))
        end do
      end if
      turn1 = 0
      turn2 = 0
      if (allocated(fields%rough)) then
        call turn_flow(fields%rough, normal_xx, first, last, j, di, dj, turned, turn1, turn2)
        turn1(:m) = turn1(:m)*s_y(:m)
        turn2(:m) = turn2(:m)*s_y(:m)
        s_x(:m) = s_x(:m) + turned(:m)*s_y(:m)
        m_xx(:m) = m_xx(:m) + turned(:m)*m_xy(:m)
        m_xy(:m) = m_xy(:m) + turned(:m)*m_yy(:m)
        h_x(:m) = h_x(:m) + turned(:m)*h_y(:m)
        onset_x(:m) = onset_x(:m) + turned(:m)*onset_y(:m)
        limit_x(:m) = limit_x(:m) + turned(:m)*limit_y(:m)
        do k = 1, nodes%levels%count
          f_x(:m, k) = f_x(:m, k) + turned(:m)*f_y(:m, k)
        end do
      end if

      by_weight = 0
      by_fluidity1 = 0
      by_fluidity2 = 0
      do k = 1, nodes%levels%count
        geometric(:m, k) = by_geometric(:m)*geometric(:m, k)/2
        by_weight(:m) = by_weight(:m) + f_x(:m, k)*(share*(f1(:, k) - f2(:, k))*by_geometric(:m)**2 &
          + (1 - 2*weight(:m))*geometric(:m, k))
        by_fluidity1(:m) = by_fluidity1(:m) + f_x(:m, k)*nodes%fluidity_p(first:last, j, k) &
          *(share*weight(:m)*f1(:, k) + geometric(:m, k))
        by_fluidity2(:m) = by_fluidity2(:m) + f_x(:m, k)*nodes%fluidity_p(first + di:last + di, j + dj, k) &
          *(share*(1 - weight(:m))*f2(:, k) + geometric(:m, k))
      end do

      ! density, weights and fluidities depend on the pressure of each node, the stresses of the flow law on both
      do c = 1, m
        i = first + c - 1
        by_mass1 = s_x(c)*mass1(c)/(2*h(c)**3) + rho(c)*by_weight(c)
        by_mass2 = s_x(c)*mass2(c)/(2*h(c)**3) - rho(c)*by_weight(c)
        by_p1 = rho1_p(c)/rho1(c)*by_mass1 + rho(c)*(by_fluidity1(c) &
          + (onset_x(c)*nodes%onset_p(i, j) + limit_x(c)*nodes%limit_p(i, j))/2)
        by_p2 = rho2_p(c)/rho2(c)*by_mass2 + rho(c)*(by_fluidity2(c) &
          + (onset_x(c)*nodes%onset_p(i + di, j + dj) + limit_x(c)*nodes%limit_p(i + di, j + dj))/2)
        by_h = rho(c)*(h_x(c) - 3*s_x(c)/h(c))/2
        faces%flow(i, j) = rho(c)*s_x(c)
        faces%mobility(i, j) = rho(c)*m_xx(c)
        faces%before(i, j) = by_p1 - rho(c)*m_xx(c)*per_length
        faces%after(i, j) = by_p2 + rho(c)*m_xx(c)*per_length
        faces%aside(i, j) = rho(c)*m_xy(c)
        faces%film_before(i, j) = by_h*widening1(c) + by_mass1*growth1(c) + rho(c)*turn1(c)
        faces%film_after(i, j) = by_h*widening2(c) + by_mass2*growth2(c) + rho(c)*turn2(c)
      end do
      if (allocated(fields%rough)) then
        call add_dragged(nodes, fields, first, last, j, di, dj, faces)
      end if
    end associate
  end subroutine flow_through

  !> Swaps the first m numbers of a and b.
  pure subroutine swap(m, a, b)
    integer, intent(in) :: m
    real(wp), intent(inout) :: a(:), b(:)
    real(wp) :: kept(m)

    kept = a(:m)
    a(:m) = b(:m)
    b(:m) = kept
  end subroutine swap

  !> Multiplies the mass of nodes first..last of row j, rho h^3, by the pressure flow factor through a face (component
  !> `normal` of the tensor), and sets their changes by the gap between mean planes: of the film, and of the mass's logarithm.
  pure subroutine widen(rough, first, last, j, normal, mass, widening, growth)
    type(rough_film), intent(in) :: rough
    integer, intent(in) :: first, last, j, normal
    real(wp), intent(inout) :: mass(:), widening(:), growth(:)
    integer :: c, i

    do c = 1, last - first + 1
      i = first + c - 1
      widening(c) = widening(c)*rough%widening(i, j)
      growth(c) = growth(c)*rough%widening(i, j) + rough%flow_h(i, j, normal)/rough%flow(i, j, normal)
      mass(c) = mass(c)*rough%flow(i, j, normal)
    end do
  end subroutine widen

  !> Computes the share of the flow along the faces that the lay of oblique roughness turns through them, and its changes by
  !> the gap at either node; arguments as of `flow_through`.
  pure subroutine turn_flow(rough, normal, first, last, j, di, dj, turned, turn1, turn2)
    type(rough_film), intent(in) :: rough
    integer, intent(in) :: normal, first, last, j, di, dj
    real(wp), intent(inout) :: turned(:), turn1(:), turn2(:)
    real(wp) :: share1, share2
    integer :: c, i

    associate (through => rough%flow(:, :, normal), aside => rough%flow(:, :, 3), through_h => rough%flow_h(:, :, normal), &
        aside_h => rough%flow_h(:, :, 3))
      do c = 1, last - first + 1
        i = first + c - 1
        share1 = aside(i, j)/through(i, j)
        share2 = aside(i + di, j + dj)/through(i + di, j + dj)
        turned(c) = (share1 + share2)/2
        turn1(c) = (aside_h(i, j) - share1*through_h(i, j))/(2*through(i, j))
        turn2(c) = (aside_h(i + di, j + dj) - share2*through_h(i + di, j + dj))/(2*through(i + di, j + dj))
      end do
    end associate
  end subroutine turn_flow

  !> Adds the oil that rough walls drag along through the faces; arguments as of `flow_through`.
  !>
  !> It depends on the gap and not on a gradient, so that thickness travels with its change by the gap, and against the
  !> entrainment where a slow rough wall slides fast over a gap of less than about its roughness. It is taken from the node
  !> upwind of the travelling thickness: with a mean of both nodes, or upwind to higher order, such films are lost.
  pure subroutine add_dragged(nodes, fields, first, last, j, di, dj, faces)
    type(sheared_oil), intent(in) :: nodes
    type(film_fields), intent(in) :: fields
    integer, intent(in) :: first, last, j, di, dj
    type(face_flow), intent(inout) :: faces
    real(wp) :: dragged(0:1), by_gap(0:1), normal, aside
    integer :: i, k, l, side, xx

    xx = merge(1, 2, di == 1)
    associate (shear => fields%rough%shear, shear_h => fields%rough%shear_h, rho => fields%rho, rho_p => fields%rho_p)
      do i = first, last
        do side = 0, 1
          k = i + side*di
          l = j + side*dj
          normal = merge(nodes%sliding_x(k, l), nodes%sliding_y(k, l), di == 1)/2
          aside = merge(nodes%sliding_y(k, l), nodes%sliding_x(k, l), di == 1)/2
          dragged(side) = shear(k, l, xx)*normal + shear(k, l, 3)*aside
          by_gap(side) = rho(k, l)*(shear_h(k, l, xx)*normal + shear_h(k, l, 3)*aside)
        end do
        ! the flow is subtracted: thickness travels against its change by the gap
        if (sum(by_gap) <= 0) then
          faces%flow(i, j) = faces%flow(i, j) + rho(i, j)*dragged(0)
          faces%before(i, j) = faces%before(i, j) + rho_p(i, j)*dragged(0)
          faces%film_before(i, j) = faces%film_before(i, j) + by_gap(0)
        else
          faces%flow(i, j) = faces%flow(i, j) + rho(k, l)*dragged(1)
          faces%after(i, j) = faces%after(i, j) + rho_p(k, l)*dragged(1)
          faces%film_after(i, j) = faces%film_after(i, j) + by_gap(1)
        end if
      end do
    end associate
  end subroutine add_dragged

  !> Stops the flow between nodes that are both at ambient pressure, where the gap may be filled in part: all that is carried
  !> there is the wedge's.
  subroutine still_ambient_faces(p, film)
    real(wp), contiguous, intent(in) :: p(:, :)
    type(sheared_film), intent(inout) :: film

    call still(film%along_x, .not. (p > 0 .or. eoshift(p, 1, dim=1) > 0))
    call still(film%along_y, .not. (p > 0 .or. eoshift(p, 1, dim=2) > 0))

  contains

    subroutine still(faces, ambient)
      type(face_flow), intent(inout) :: faces
      logical, intent(in) :: ambient(:, :)

      where (ambient)
        faces%flow = 0
        faces%film_before = 0
        faces%film_after = 0
      end where
    end subroutine still

  end subroutine still_ambient_faces

  !> Net volume outflow per area [m/s] of each inner node's cell; zero on the outline.
  subroutine sheared_imbalance(grid, film, fields, imbalance)
    type(film_grid), intent(in) :: grid
    type(sheared_film), intent(inout) :: film
    type(film_fields), intent(in) :: fields
    real(wp), contiguous, intent(out) :: imbalance(:, :)
    integer :: j

    !$omp parallel do schedule(static)
    do j = 1, grid%ny
      film%mass(:, j) = fields%rho(:, j)*fields%h(:, j)
      imbalance(:, j) = grid%implicit_rate*film%mass(:, j) + grid%explicit_rate(:, j)
    end do
    call add_wedge(grid, film%mass, imbalance)
    call take_inflow(grid, film%along_x%flow, film%along_y%flow, imbalance)
  end subroutine sheared_imbalance

  !> Change of the imbalance for a small change of the oil's pressure and the film, of rough surfaces the gap between mean
  !> planes: the exact Jacobian times (dp, dh).
  subroutine sheared_imbalance_change(grid, film, fields, dp, dh, change)
    type(film_grid), intent(in) :: grid
    type(sheared_film), intent(inout) :: film
    type(film_fields), intent(in) :: fields
    real(wp), contiguous, intent(in) :: dp(:, :), dh(:, :)
    real(wp), contiguous, intent(out) :: change(:, :)
    integer :: i, j

    call set_mass_change(fields, dp, dh, film%mass)
    !$omp parallel do schedule(static)
    do j = 1, grid%ny
      change(:, j) = grid%implicit_rate*film%mass(:, j)
    end do
    call add_wedge(grid, film%mass, change)
    associate (x => film%along_x, y => film%along_y, slope_x => 1/(4*grid%dx), slope_y => 1/(4*grid%dy))
      !$omp parallel do private(i) schedule(static)
      do j = 2, grid%ny - 1
        block
          real(wp) :: within(grid%nx), enter(grid%nx), leave(grid%nx)

          do i = 1, grid%nx - 1
            within(i) = x%before(i, j)*dp(i, j) + x%after(i, j)*dp(i + 1, j) + x%film_before(i, j)*dh(i, j) &
              + x%film_after(i, j)*dh(i + 1, j) + x%aside(i, j)*slope_y*(dp(i, j + 1) - dp(i, j - 1) &
              + dp(i + 1, j + 1) - dp(i + 1, j - 1))
          end do
          call change_between(j - 1, enter)
          call change_between(j, leave)
          do i = 2, grid%nx - 1
            change(i, j) = change(i, j) - (within(i) - within(i - 1))/grid%dx - (leave(i) - enter(i))/grid%dy
          end do
        end block
      end do
    end associate

  contains

    !> Computes the change of the flow from the nodes of row j to those of the next.
    pure subroutine change_between(j, flow)
      integer, intent(in) :: j
      real(wp), intent(out) :: flow(:)
      real(wp) :: slope
      integer :: i

      slope = 1/(4*grid%dx)
      flow(1) = 0
      associate (y => film%along_y)
        do i = 2, grid%nx - 1
          flow(i) = y%before(i, j)*dp(i, j) + y%after(i, j)*dp(i, j + 1) + y%film_before(i, j)*dh(i, j) &
            + y%film_after(i, j)*dh(i, j + 1) + y%aside(i, j)*slope*(dp(i + 1, j) - dp(i - 1, j) &
            + dp(i + 1, j + 1) - dp(i - 1, j + 1))
        end do
      end associate
    end subroutine change_between

  end subroutine sheared_imbalance_change

  !> Subtracts the net inflow through the faces after the nodes, along x and along y.
  subroutine take_inflow(grid, along_x, along_y, r)
    type(film_grid), intent(in) :: grid
    real(wp), contiguous, intent(in) :: along_x(:, :), along_y(:, :)
    real(wp), contiguous, intent(inout) :: r(:, :)
    integer :: i, j

    !$omp parallel do private(i) schedule(static)
    do j = 2, grid%ny - 1
      do i = 2, grid%nx - 1
        r(i, j) = r(i, j) - (along_x(i, j) - along_x(i - 1, j))/grid%dx - (along_y(i, j) - along_y(i, j - 1))/grid%dy
      end do
    end do
  end subroutine take_inflow

end module pyworm_sheared_reynolds
