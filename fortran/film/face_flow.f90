!> Flow of a sheared film through the faces between nodes, linearised in the pressure and the film of the nodes.
!>
!> The flow through a face is rho S (`sheared_reynolds`), S that of the two nodes' mean film and fluidity under the pressure
!> gradient at the face (`shear_flow`). Between rough surfaces the pressure flow factors multiply S, and the shear flow factors
!> add what the rougher wall drags along. A strip of faces lies between the nodes of a row and the next along x or along y.
module pyworm_face_flow
  use pyworm_flow_laws, only: hardens
  use pyworm_kinds, only: wp
  use pyworm_reynolds, only: film_fields
  use pyworm_rough_surfaces, only: rough_film
  use pyworm_shear_flow, only: deficit_change, new_deficit_change, flow_change, flow_change_by_stresses, flow_deficit
  use pyworm_shear_stress, only: solve_shear
  use pyworm_sheared_oil, only: sheared_oil, oil_warming
  use pyworm_status, only: status_ok, status_no_memory
  use pyworm_strip_of_points, only: shear_strip, new_shear_strip
  implicit none(type, external)
  private

  public :: face_flow, new_face_flow, face_strip, face_work, new_face_work, flow_through, flow_by_temperature

  !> Faces treated together: enough for vectors, few enough to stay in the first cache.
  integer, parameter, public :: most_faces = 64

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

  !> A strip of faces: those after the nodes first..last of a row, towards the nodes (di, dj) further on, (1, 0) or (0, 1).
  type :: face_strip
    integer :: row = 0, first = 0, last = 0, di = 1, dj = 0
    !> Reciprocal spacing of the nodes [1/m].
    real(wp) :: per_length = 0
    !> Pressure gradient through the faces and along them [Pa/m].
    real(wp) :: normal(most_faces), aside(most_faces)
  end type face_strip

  !> Nodes on one side of a strip of faces.
  type :: node_strip
    integer :: row = 0, first = 0, last = 0
    !> Film [m], not below the floor, and its weight in the mean of a face: rho h**3 times the pressure flow factor [m3].
    real(wp) :: film(most_faces), mass(most_faces)
    !> Changes by the gap: of the film, of the logarithm of its mass [1/m], and of the flow aside that is turned [m/s].
    real(wp) :: widening(most_faces), growth(most_faces), turn(most_faces)
    !> Change of S by the node's fluidities, by pressure [m2/(s Pa)].
    real(wp) :: by_fluidity(most_faces)
  end type node_strip

  !> Mean of the nodes before and after the faces of a strip.
  type :: face_mean
    !> Weight of the node before, density [-], and the root of both nodes' weights.
    real(wp) :: weight(most_faces), rho(most_faces), root(most_faces)
    !> Change of S through the weights, by the logarithm of the mass of the node before; that by the other's is minus it [m2/s].
    real(wp) :: by_weight(most_faces)
    !> Geometric means of the nodes' fluidities at the levels, times twice their share [1/(Pa s)].
    real(wp), allocatable :: geometric(:, :)
  end type face_mean

  !> Scratch of a thread; `by_stresses` asks for the changes by the flow law's stresses of a law that does not harden, too,
  !> `flow_alone` for no changes at all: they are those of an evaluation before.
  type :: face_work
    logical :: by_stresses = .false., flow_alone = .false.
    type(shear_strip) :: shear
    type(deficit_change) :: deficit
    type(node_strip) :: before, after
    type(face_mean) :: mean
  end type face_work

contains

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

  !> Allocates a thread's scratch.
  subroutine new_face_work(levels, work, stat)
    integer, intent(in) :: levels
    type(face_work), intent(out) :: work
    integer, intent(out) :: stat
    integer :: err

    call new_shear_strip(most_faces, levels, work%shear, stat)
    if (stat == status_ok) call new_deficit_change(most_faces, levels, work%deficit, stat)
    allocate (work%mean%geometric(most_faces, levels), stat=err)
    if (err /= 0) stat = status_no_memory
  end subroutine new_face_work

  !> Computes the linearised flow through a strip of faces.
  subroutine flow_through(nodes, fields, floor, faces, work, flows)
    type(sheared_oil), intent(in) :: nodes
    type(film_fields), intent(in) :: fields
    real(wp), intent(in) :: floor
    type(face_strip), intent(in) :: faces
    type(face_work), intent(inout) :: work
    type(face_flow), intent(inout) :: flows

    work%before%row = faces%row
    work%before%first = faces%first
    work%before%last = faces%last
    work%after%row = faces%row + faces%dj
    work%after%first = faces%first + faces%di
    work%after%last = faces%last + faces%di
    call set_nodes(fields, floor, merge(1, 2, faces%di == 1), work%before)
    call set_nodes(fields, floor, merge(1, 2, faces%di == 1), work%after)
    call average(nodes, faces, work%before, work%after, work%mean, work%shear)
    call solve_faces(nodes, faces, work%shear, flows)
    if (work%flow_alone .and. .not. fields%is_rough()) then
      call set_flow_alone(nodes, faces, work%shear, work%mean, work%deficit, flows)
      return
    end if
    call shear_faces(nodes, faces, work%by_stresses .or. hardens(nodes%law), work%shear, work%deficit)
    if (fields%is_rough()) then
      call turn_flow(fields%rough, faces, nodes%levels%count, work%before, work%after, work%deficit)
    end if
    call set_fluidity_changes(nodes, work%deficit, work%mean, work%before, work%after)
    call linearise(nodes, fields, faces, work%shear, work%deficit, work%mean, work%before, work%after, flows)
    if (fields%is_rough()) call add_dragged(nodes, fields, faces, flows)
  end subroutine flow_through

  !> Sets film and weight of the nodes on one side, and their changes by the gap, of rough surfaces that between mean planes;
  !> `normal` is the component of the flow factors' tensor through the faces.
  pure subroutine set_nodes(fields, floor, normal, side)
    type(film_fields), intent(in) :: fields
    real(wp), intent(in) :: floor
    integer, intent(in) :: normal
    type(node_strip), intent(inout) :: side
    integer :: m, c, i

    m = side%last - side%first + 1
    associate (first => side%first, last => side%last, j => side%row)
      side%turn = 0
      side%film(:m) = max(fields%h(first:last, j), floor)
      side%mass(:m) = fields%rho(first:last, j)*side%film(:m)**3
      side%widening(:m) = merge(1.0_wp, 0.0_wp, fields%h(first:last, j) > floor)
      side%growth(:m) = 3*side%widening(:m)/side%film(:m)
      if (.not. fields%is_rough()) return
      associate (rough => fields%rough)
        do c = 1, m
          i = first + c - 1
          side%widening(c) = side%widening(c)*rough%widening(i, j)
          side%growth(c) = side%growth(c)*rough%widening(i, j) + rough%flow_h(i, j, normal)/rough%flow(i, j, normal)
          side%mass(c) = side%mass(c)*rough%flow(i, j, normal)
        end do
      end associate
    end associate
  end subroutine set_nodes

  !> Sets film, gradient, sliding, stresses and fluidity at the faces from the nodes on both sides.
  pure subroutine average(nodes, faces, before, after, mean, shear)
    type(sheared_oil), intent(in) :: nodes
    type(face_strip), intent(in) :: faces
    type(node_strip), intent(in) :: before, after
    type(face_mean), intent(inout) :: mean
    type(shear_strip), intent(inout) :: shear
    integer :: m, k

    m = faces%last - faces%first + 1
    shear%points = m
    if (faces%di == 1) then
      shear%px(:m) = faces%normal(:m)
      shear%py(:m) = faces%aside(:m)
    else
      shear%px(:m) = faces%aside(:m)
      shear%py(:m) = faces%normal(:m)
    end if
    associate (share => nodes%arithmetic, h => shear%film(:m), &
        f1 => nodes%fluidity(before%first:before%last, before%row, :), f2 => nodes%fluidity(after%first:after%last, after%row, :))
      ! with weights w = rho h**3 the mobility of a Newtonian oil's face is share (M1 + M2)/2 + (1 - share) sqrt(M1 M2) of its
      ! nodes' M = w f, near their logarithmic mean (`arithmetic_share`)
      mean%weight(:m) = before%mass(:m)/(before%mass(:m) + after%mass(:m))
      h = (before%film(:m) + after%film(:m))/2
      mean%rho(:m) = (before%mass(:m) + after%mass(:m))/(2*h**3)
      mean%root(:m) = sqrt(mean%weight(:m)*(1 - mean%weight(:m)))
      do k = 1, nodes%levels%count
        mean%geometric(:m, k) = 2*(1 - share)*sqrt(f1(:, k)*f2(:, k))
        shear%fluidity(:m, k) = share*(mean%weight(:m)*f1(:, k) + (1 - mean%weight(:m))*f2(:, k)) &
          + mean%root(:m)*mean%geometric(:m, k)
      end do
    end associate
    call halve_sum(nodes%sliding_x, shear%us)
    call halve_sum(nodes%sliding_y, shear%vs)
    call halve_sum(nodes%onset, shear%reference)
    call halve_sum(nodes%limit, shear%limit)

  contains

    !> Mean of a nodal field at the faces.
    pure subroutine halve_sum(field, at_faces)
      real(wp), intent(in) :: field(:, :)
      real(wp), contiguous, intent(inout) :: at_faces(:)

      at_faces(:m) = (field(before%first:before%last, before%row) + field(after%first:after%last, after%row))/2
    end subroutine halve_sum

  end subroutine average

  !> Solves for the stresses of the faces, from those found last.
  subroutine solve_faces(nodes, faces, shear, flows)
    type(sheared_oil), intent(in) :: nodes
    type(face_strip), intent(in) :: faces
    type(shear_strip), intent(inout) :: shear
    type(face_flow), intent(inout) :: flows
    integer :: m, failures

    m = shear%points
    associate (first => faces%first, last => faces%last, j => faces%row)
      shear%tau_x(:m) = flows%stress_x(first:last, j)
      shear%tau_y(:m) = flows%stress_y(first:last, j)
      call solve_shear(nodes%law, nodes%levels, shear, failures)
      shear%unsolved = shear%unsolved + failures
      flows%stress_x(first:last, j) = shear%tau_x(:m)
      flows%stress_y(first:last, j) = shear%tau_y(:m)
    end associate
  end subroutine solve_faces

  !> Sets the flow through the faces of smooth surfaces without its changes.
  pure subroutine set_flow_alone(nodes, faces, shear, mean, deficit, flows)
    type(sheared_oil), intent(in) :: nodes
    type(face_strip), intent(in) :: faces
    type(shear_strip), intent(in) :: shear
    type(face_mean), intent(in) :: mean
    type(deficit_change), intent(inout) :: deficit
    type(face_flow), intent(inout) :: flows

    call flow_deficit(nodes%levels, shear, deficit%x, deficit%y)
    associate (m => shear%points, through => flows%flow(faces%first:faces%last, faces%row))
      if (faces%di == 1) then
        through = mean%rho(:m)*deficit%x(:m)
      else
        through = mean%rho(:m)*deficit%y(:m)
      end if
    end associate
  end subroutine set_flow_alone

  !> Computes the flow that the stresses of the faces make with its changes; of these x then is through the faces and y along
  !> them. Those by the flow law's stresses are computed if `by_stresses`.
  subroutine shear_faces(nodes, faces, by_stresses, shear, deficit)
    type(sheared_oil), intent(in) :: nodes
    type(face_strip), intent(in) :: faces
    logical, intent(in) :: by_stresses
    type(shear_strip), intent(inout) :: shear
    type(deficit_change), intent(inout) :: deficit

    call flow_change(nodes%levels, shear, deficit)
    if (by_stresses) then
      call flow_change_by_stresses(nodes%law, nodes%levels, shear, deficit)
    else
      deficit%by_onset_x = 0
      deficit%by_onset_y = 0
      deficit%by_limit_x = 0
      deficit%by_limit_y = 0
    end if
    if (faces%di == 0) call swap_directions(shear%points, nodes%levels%count, deficit)
  end subroutine shear_faces

  !> Swaps the directions of the first m points.
  pure subroutine swap_directions(m, levels, deficit)
    integer, intent(in) :: m, levels
    type(deficit_change), intent(inout) :: deficit
    integer :: k

    call swap(deficit%x, deficit%y)
    call swap(deficit%mobility_xx, deficit%mobility_yy)
    call swap(deficit%by_film_x, deficit%by_film_y)
    call swap(deficit%by_onset_x, deficit%by_onset_y)
    call swap(deficit%by_limit_x, deficit%by_limit_y)
    do k = 1, levels
      call swap(deficit%by_fluidity_x(:, k), deficit%by_fluidity_y(:, k))
    end do

  contains

    pure subroutine swap(a, b)
      real(wp), intent(inout) :: a(:), b(:)
      real(wp) :: kept(m)

      kept = a(:m)
      a(:m) = b(:m)
      b(:m) = kept
    end subroutine swap

  end subroutine swap_directions

  !> Adds the share of the flow along the faces that the lay of oblique roughness turns through them, and sets its changes by
  !> the gap at the nodes on either side.
  pure subroutine turn_flow(rough, faces, levels, before, after, deficit)
    type(rough_film), intent(in) :: rough
    type(face_strip), intent(in) :: faces
    integer, intent(in) :: levels
    type(node_strip), intent(inout) :: before, after
    type(deficit_change), intent(inout) :: deficit
    real(wp) :: turned(most_faces), share1, share2
    integer :: m, c, i, j, k, di, dj, normal

    m = faces%last - faces%first + 1
    j = faces%row
    di = faces%di
    dj = faces%dj
    normal = merge(1, 2, di == 1)
    associate (through => rough%flow(:, :, normal), aside => rough%flow(:, :, 3), through_h => rough%flow_h(:, :, normal), &
        aside_h => rough%flow_h(:, :, 3), s => deficit)
      do c = 1, m
        i = faces%first + c - 1
        share1 = aside(i, j)/through(i, j)
        share2 = aside(i + di, j + dj)/through(i + di, j + dj)
        turned(c) = (share1 + share2)/2
        before%turn(c) = (aside_h(i, j) - share1*through_h(i, j))/(2*through(i, j))
        after%turn(c) = (aside_h(i + di, j + dj) - share2*through_h(i + di, j + dj))/(2*through(i + di, j + dj))
      end do
      before%turn(:m) = before%turn(:m)*s%y(:m)
      after%turn(:m) = after%turn(:m)*s%y(:m)
      s%x(:m) = s%x(:m) + turned(:m)*s%y(:m)
      s%mobility_xx(:m) = s%mobility_xx(:m) + turned(:m)*s%mobility_xy(:m)
      s%mobility_xy(:m) = s%mobility_xy(:m) + turned(:m)*s%mobility_yy(:m)
      s%by_film_x(:m) = s%by_film_x(:m) + turned(:m)*s%by_film_y(:m)
      s%by_onset_x(:m) = s%by_onset_x(:m) + turned(:m)*s%by_onset_y(:m)
      s%by_limit_x(:m) = s%by_limit_x(:m) + turned(:m)*s%by_limit_y(:m)
      do k = 1, levels
        s%by_fluidity_x(:m, k) = s%by_fluidity_x(:m, k) + turned(:m)*s%by_fluidity_y(:m, k)
      end do
    end associate
  end subroutine turn_flow

  !> Computes the changes of S through the nodes' weights, and by the fluidities of both nodes.
  pure subroutine set_fluidity_changes(nodes, deficit, mean, before, after)
    type(sheared_oil), intent(in) :: nodes
    type(deficit_change), intent(in) :: deficit
    type(face_mean), intent(inout) :: mean
    type(node_strip), intent(inout) :: before, after
    integer :: m, k

    m = before%last - before%first + 1
    mean%by_weight = 0
    before%by_fluidity = 0
    after%by_fluidity = 0
    associate (share => nodes%arithmetic, weight => mean%weight(:m), geometric => mean%geometric, f_x => deficit%by_fluidity_x, &
        f1 => nodes%fluidity(before%first:before%last, before%row, :), f2 => nodes%fluidity(after%first:after%last, after%row, :), &
        f1_p => nodes%fluidity_p(before%first:before%last, before%row, :), &
        f2_p => nodes%fluidity_p(after%first:after%last, after%row, :))
      ! of the weight w by ln(mass): w (1 - w), the square of `root`, whose own change by w is (1 - 2 w)/(2 root)
      do k = 1, nodes%levels%count
        geometric(:m, k) = mean%root(:m)*geometric(:m, k)/2
        mean%by_weight(:m) = mean%by_weight(:m) + f_x(:m, k)*(share*(f1(:, k) - f2(:, k))*mean%root(:m)**2 &
          + (1 - 2*weight)*geometric(:m, k))
        before%by_fluidity(:m) = before%by_fluidity(:m) + f_x(:m, k)*f1_p(:, k)*(share*weight*f1(:, k) + geometric(:m, k))
        after%by_fluidity(:m) = after%by_fluidity(:m) + f_x(:m, k)*f2_p(:, k)*(share*(1 - weight)*f2(:, k) + geometric(:m, k))
      end do
    end associate
  end subroutine set_fluidity_changes

  !> Sets the flow through the faces and its derivatives: density, weights and fluidities depend on the pressure of each node,
  !> the stresses of the flow law on both.
  pure subroutine linearise(nodes, fields, faces, shear, s, mean, before, after, flows)
    type(sheared_oil), intent(in) :: nodes
    type(film_fields), intent(in) :: fields
    type(face_strip), intent(in) :: faces
    type(shear_strip), intent(in) :: shear
    type(deficit_change), intent(in) :: s
    type(face_mean), intent(in) :: mean
    type(node_strip), intent(in) :: before, after
    type(face_flow), intent(inout) :: flows
    real(wp) :: by_mass1, by_mass2, by_p1, by_p2, by_h
    integer :: c, i, j, k, l

    j = before%row
    l = after%row
    associate (h => shear%film, rho => mean%rho, onset_p => nodes%onset_p, limit_p => nodes%limit_p)
      do c = 1, before%last - before%first + 1
        i = before%first + c - 1
        k = after%first + c - 1
        ! rho = (mass1 + mass2)/(2 h**3): changes of rho S by the logarithms of the masses, and by the mean film h
        by_mass1 = s%x(c)*before%mass(c)/(2*h(c)**3) + rho(c)*mean%by_weight(c)
        by_mass2 = s%x(c)*after%mass(c)/(2*h(c)**3) - rho(c)*mean%by_weight(c)
        by_p1 = fields%rho_p(i, j)/fields%rho(i, j)*by_mass1 + rho(c)*(before%by_fluidity(c) &
          + (s%by_onset_x(c)*onset_p(i, j) + s%by_limit_x(c)*limit_p(i, j))/2)
        by_p2 = fields%rho_p(k, l)/fields%rho(k, l)*by_mass2 + rho(c)*(after%by_fluidity(c) &
          + (s%by_onset_x(c)*onset_p(k, l) + s%by_limit_x(c)*limit_p(k, l))/2)
        by_h = rho(c)*(s%by_film_x(c) - 3*s%x(c)/h(c))/2
        flows%flow(i, j) = rho(c)*s%x(c)
        flows%mobility(i, j) = rho(c)*s%mobility_xx(c)
        flows%before(i, j) = by_p1 - rho(c)*s%mobility_xx(c)*faces%per_length
        flows%after(i, j) = by_p2 + rho(c)*s%mobility_xx(c)*faces%per_length
        flows%aside(i, j) = rho(c)*s%mobility_xy(c)
        flows%film_before(i, j) = by_h*before%widening(c) + by_mass1*before%growth(c) + rho(c)*before%turn(c)
        flows%film_after(i, j) = by_h*after%widening(c) + by_mass2*after%growth(c) + rho(c)*after%turn(c)
      end do
    end associate
  end subroutine linearise

  !> Adds the oil that rough walls drag along through the faces.
  !>
  !> It depends on the gap and not on a gradient, so that thickness travels with its change by the gap, and against the
  !> entrainment where a slow rough wall slides fast over a gap of less than about its roughness. It is taken from the node
  !> upwind of the travelling thickness: with a mean of both nodes, or upwind to higher order, such films are lost.
  pure subroutine add_dragged(nodes, fields, faces, flows)
    type(sheared_oil), intent(in) :: nodes
    type(film_fields), intent(in) :: fields
    type(face_strip), intent(in) :: faces
    type(face_flow), intent(inout) :: flows
    real(wp) :: dragged(0:1), by_gap(0:1)
    integer :: i, j, k, l

    j = faces%row
    l = j + faces%dj
    associate (rho => fields%rho, rho_p => fields%rho_p)
      do i = faces%first, faces%last
        k = i + faces%di
        call set_dragged(nodes, fields, faces, i, dragged, by_gap)
        if (from_before(by_gap)) then
          flows%flow(i, j) = flows%flow(i, j) + rho(i, j)*dragged(0)
          flows%before(i, j) = flows%before(i, j) + rho_p(i, j)*dragged(0)
          flows%film_before(i, j) = flows%film_before(i, j) + by_gap(0)
        else
          flows%flow(i, j) = flows%flow(i, j) + rho(k, l)*dragged(1)
          flows%after(i, j) = flows%after(i, j) + rho_p(k, l)*dragged(1)
          flows%film_after(i, j) = flows%film_after(i, j) + by_gap(1)
        end if
      end do
    end associate
  end subroutine add_dragged

  !> Whether the dragged oil is that of the node before: the flow is subtracted, thickness travels against its change by the
  !> gap.
  pure logical function from_before(by_gap)
    real(wp), intent(in) :: by_gap(0:1)

    from_before = sum(by_gap) <= 0
  end function from_before

  !> Volume of oil dragged along at the nodes before and after the face of node i [m2/s], and the change of its mass by the gap.
  pure subroutine set_dragged(nodes, fields, faces, i, dragged, by_gap)
    type(sheared_oil), intent(in) :: nodes
    type(film_fields), intent(in) :: fields
    type(face_strip), intent(in) :: faces
    integer, intent(in) :: i
    real(wp), intent(out) :: dragged(0:1), by_gap(0:1)
    real(wp) :: normal, aside
    integer :: k, l, side, xx

    xx = merge(1, 2, faces%di == 1)
    associate (shear => fields%rough%shear, shear_h => fields%rough%shear_h, rho => fields%rho)
      do side = 0, 1
        k = i + side*faces%di
        l = faces%row + side*faces%dj
        normal = merge(nodes%sliding_x(k, l), nodes%sliding_y(k, l), faces%di == 1)/2
        aside = merge(nodes%sliding_y(k, l), nodes%sliding_x(k, l), faces%di == 1)/2
        dragged(side) = shear(k, l, xx)*normal + shear(k, l, 3)*aside
        by_gap(side) = rho(k, l)*(shear_h(k, l, xx)*normal + shear_h(k, l, 3)*aside)
      end do
    end associate
  end subroutine set_dragged

  !> Computes the derivatives of the flow through a strip of faces by the temperatures of the nodes before and after each
  !> [m2/(s K)], (level, node, face), right after `flow_through` with `by_stresses` for the same strip.
  pure subroutine flow_by_temperature(nodes, fields, warming, faces, work, by_temperature)
    type(sheared_oil), intent(in) :: nodes
    type(film_fields), intent(in) :: fields
    type(oil_warming), intent(in) :: warming
    type(face_strip), intent(in) :: faces
    type(face_work), intent(in) :: work
    real(wp), intent(out) :: by_temperature(:, 0:, :)
    real(wp) :: share(0:1), by_mass(0:1), by_mean, dragged(0:1), by_gap(0:1)
    integer :: c, i, j, k, side

    associate (s => work%deficit, mean => work%mean, arithmetic => nodes%arithmetic)
      do c = 1, faces%last - faces%first + 1
        share = [mean%weight(c), 1 - mean%weight(c)]
        ! as in `linearise`
        by_mass = s%x(c)*[work%before%mass(c), work%after%mass(c)]/(2*work%shear%film(c)**3) &
          + [1, -1]*mean%rho(c)*mean%by_weight(c)
        dragged = 0
        if (fields%is_rough()) then
          call set_dragged(nodes, fields, faces, faces%first + c - 1, dragged, by_gap)
          dragged(merge(1, 0, from_before(by_gap))) = 0
        end if
        do side = 0, 1
          i = faces%first + c - 1 + side*faces%di
          j = faces%row + side*faces%dj
          by_mean = warming%rho(i, j)*(by_mass(side)/fields%rho(i, j) + dragged(side)) &
            + mean%rho(c)*s%by_onset_x(c)*warming%onset(i, j)/2
          do k = 1, nodes%levels%count
            by_temperature(k, side, c) = nodes%levels%weight(k)*by_mean + mean%rho(c)*s%by_fluidity_x(c, k) &
              *warming%fluidity(i, j, k)*(arithmetic*share(side)*nodes%fluidity(i, j, k) + mean%geometric(c, k))
          end do
        end do
      end do
    end associate
  end subroutine flow_by_temperature

end module pyworm_face_flow
