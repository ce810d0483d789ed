!> The flow of a sheared line contact: Newton's in its limit, its bands the derivative of its imbalance, a closed form.
program test_line_shear
  use pyworm_film_newton, only: newton_step, set_transient_term, shear_contact, film_residual, film_step
  use pyworm_flow_laws, only: flow_law, law_newton, law_eyring, law_bair_winer, law_eyring_limited, law_carreau
  use pyworm_kinds, only: wp
  use pyworm_line_film, only: line_contact, new_line_contact
  use pyworm_shear_fields, only: shear_field, nodal_shear
  use pyworm_viscosity_density, only: oil_law, law_barus, law_roelands
  use pyworm_status, only: status_ok
  use tap, only: check, close_to, done
  implicit none(type, external)

  integer, parameter :: n = 151, levels = 7
  real(wp), parameter :: floor = 1e-9_wp, dx = 2e-5_wp, modulus = 226e9_wp, radius = 0.02_wp, load = 5e5_wp
  !> A worm wheel's oil, with a pressure of some 500 MPa over a millimetre.
  type(oil_law), parameter :: oil = oil_law(law_roelands, 0.227_wp, 0.227_wp, 1.961e8_wp, 0.67e-9_wp, 2.68e-9_wp, &
    333.15_wp, 0.782_wp, 7.1e-4_wp, 1.5e-9_wp)
  real(wp), parameter :: tau0 = 3e6_wp
  real(wp), parameter :: implicit_rate = 300
  real(wp) :: x(n), p(n), u(n), sliding(n), explicit_rate(n), h0
  logical :: covered(n)
  integer :: stat

  call set_scene()
  call newtonian_limit()
  call jacobian(flow_law(law_newton), "Newtonian")
  call jacobian(flow_law(law_eyring, tau0, 1e-9_wp, 2e-3_wp), "Eyring")
  call jacobian(flow_law(law_bair_winer, limit=1e7_wp, limit_growth=0.1_wp), "Bair and Winer")
  call jacobian(flow_law(law_eyring_limited, tau0, limit=5e6_wp, limit_growth=0.05_wp, exponent=2.0_wp), &
    "limited Eyring, lambda 2, near its limit")
  call jacobian(flow_law(law_carreau, tau0, exponent=0.42_wp), "Carreau")
  call solves()
  call eyring_between_plates()
  call done()

contains

  !> A field of a line contact as the film takes it.
  pure function on_nodes(a) result(field)
    real(wp), intent(in) :: a(:)
    real(wp) :: field(size(a), 1)

    field(:, 1) = a
  end function on_nodes

  !> A film under load that slides, entrained to both sides.
  subroutine set_scene()
    integer :: i

    x = [((i - n/2)*dx, i=1, n)]
    p = 5e8_wp*exp(-2*(x/5e-4_wp)**2)*(1 + 200*x)
    u = 1.5_wp*cos(x/1e-3_wp)
    sliding = 2.5_wp - 100*x
    explicit_rate = 0.1_wp*x
    covered = .true.
    h0 = 2e-6_wp
  end subroutine set_scene

  subroutine new_contact(contact)
    type(line_contact), intent(out) :: contact

    call new_line_contact(contact, x**2/(2*radius), covered, u, dx, modulus, oil, load, floor, stat)
    if (stat == status_ok) call set_transient_term(contact, implicit_rate, on_nodes(explicit_rate), stat)
    call check(stat == status_ok, "a contact is made")
  end subroutine new_contact

  !> A Newtonian oil of one temperature flows as by `line_reynolds`, to rounding, whatever slides.
  subroutine newtonian_limit()
    type(line_contact) :: plain, sheared
    real(wp) :: residual, load_error, direction(n + 1), by_plain(n + 1), by_sheared(n + 1), lift
    integer :: i

    call new_contact(plain)
    call new_contact(sheared)
    call shear_contact(sheared, flow_law(law_newton), levels, on_nodes(sliding), on_nodes(0*sliding), stat)
    call check(stat == status_ok, "it is sheared")
    lift = lifted(plain)
    call film_residual(plain, on_nodes(p), lift, residual, load_error)
    call film_residual(sheared, on_nodes(p), lift, residual, load_error)
    call close_to(maxval(abs(sheared%imbalance - plain%imbalance)), 0.0_wp, 1e-12_wp*maxval(abs(plain%imbalance)), &
      "Newton's limit")
    call plain%linearise(stat)
    call sheared%linearise(stat)
    direction(:n) = [(p(i)*sin(0.7_wp*i), i=1, n)]
    direction(n + 1) = 1e-7_wp
    call plain%multiply(direction, by_plain)
    call sheared%multiply(direction, by_sheared)
    call close_to(maxval(abs(by_sheared(:n) - by_plain(:n))), 0.0_wp, 1e-11_wp*maxval(abs(by_plain(:n))), &
      "and its Jacobian")
  end subroutine newtonian_limit

  !> Rigid film at which the thinnest film is h0.
  real(wp) function lifted(contact)
    type(line_contact), intent(inout) :: contact
    real(wp) :: residual, load_error

    call film_residual(contact, on_nodes(p), 0.0_wp, residual, load_error)
    lifted = h0 - minval(contact%model%fields%h)
  end function lifted

  !> The written Jacobian, hot and unequally at its walls, against central differences of the imbalance.
  subroutine jacobian(law, what)
    type(flow_law), intent(in) :: law
    character(len=*), intent(in) :: what
    real(wp), parameter :: step = 1e-5_wp
    type(line_contact) :: contact
    real(wp) :: direction(n + 1), above(n), below(n), got(n + 1), residual, load_error, lift
    integer :: i, k

    call new_contact(contact)
    call shear_contact(contact, law, levels, on_nodes(sliding), on_nodes(0*sliding), stat)
    do k = 1, levels
      contact%model%shear%nodes%rise(:, 1, k) = p/maxval(p)*(20 + 30*real((k - 1)*(levels - k), wp)/9 + 4*k)
    end do
    lift = lifted(contact)
    direction(:n) = [(p(i)*sin(0.7_wp*i), i=1, n)]
    direction([1, n]) = 0
    direction(n + 1) = 0.3_wp*h0
    call film_residual(contact, on_nodes(p + step*direction(:n)), lift + step*direction(n + 1), residual, load_error)
    above = contact%imbalance(:, 1)
    call film_residual(contact, on_nodes(p - step*direction(:n)), lift - step*direction(n + 1), residual, load_error)
    below = contact%imbalance(:, 1)
    call film_residual(contact, on_nodes(p), lift, residual, load_error)
    call contact%linearise(stat)
    call contact%multiply(direction, got)
    call close_to(maxval(abs(got(:n) - (above - below)/(2*step))), 0.0_wp, 2e-6_wp*maxval(abs(got(:n))), &
      what//": Jacobian against differences")
  end subroutine jacobian

  !> Newton's method converges on a loaded Eyring film that slides, as fast as on a Newtonian one.
  subroutine solves()
    type(line_contact) :: contact
    real(wp) :: pressure(n, 1), film, residual, load_error
    type(newton_step) :: step
    integer :: steps

    u = 1
    sliding = -1
    pressure(:, 1) = 4e8_wp*sqrt(max(0.0_wp, 1 - (x/6e-4_wp)**2)) + 1e2_wp
    pressure([1, n], 1) = 0
    call new_line_contact(contact, x**2/(2*radius), covered, u, dx, modulus, oil, 2e5_wp, floor, stat)
    call shear_contact(contact, flow_law(law_eyring, tau0), levels, on_nodes(sliding), on_nodes(0*sliding), stat)
    call film_residual(contact, pressure, 0.0_wp, residual, load_error)
    film = 1.5e-6_wp - contact%model%fields%h(n/2, 1)
    call film_residual(contact, pressure, film, residual, load_error)
    do steps = 1, 20
      call film_step(contact, 1e-4_wp, pressure, film, residual, load_error, step, stat)
      if (stat /= status_ok .or. residual + abs(load_error) < 1e-9_wp) exit
    end do
    call check(residual + abs(load_error) < 1e-9_wp .and. steps <= 12, "Newton converges on an Eyring film")
  end subroutine solves

  !> Eyring oil of one viscosity between parallel plates without gradient: tau = tau0 asinh(eta us/(tau0 h)), whose work
  !> is tau us.
  subroutine eyring_between_plates()
    type(line_contact) :: contact
    type(shear_field) :: field
    real(wp), parameter :: eta = 0.3_wp, slide = 2.0_wp, film = 3e-7_wp
    real(wp) :: residual, load_error, tau

    sliding = slide
    p = 0
    call new_line_contact(contact, 0*x, covered, u, dx, modulus, &
      oil_law(law_barus, eta, 2e-8_wp, 1.0_wp, 0.0_wp, 0.0_wp), load, floor, stat)
    call set_transient_term(contact, 0.0_wp, on_nodes(0*x + 1e-6_wp), stat)
    call shear_contact(contact, flow_law(law_eyring, tau0), levels, on_nodes(sliding), on_nodes(0*sliding), stat)
    call film_residual(contact, on_nodes(p), film, residual, load_error)
    call nodal_shear(contact, .false., field, stat)
    tau = tau0*asinh(eta*slide/(tau0*film))
    associate (inner => field%stress_x(2:n - 1, 1))
      call close_to(maxval(abs(inner - tau)), 0.0_wp, 1e-9_wp*tau, "Eyring's stress")
    end associate
    call close_to(maxval(abs(field%friction(2:n - 1, 1) - tau*slide)), 0.0_wp, 1e-9_wp*tau*slide, "and its work")
    call close_to(maxval(abs(field%rate(2:n - 1, 1) - slide/film)), 0.0_wp, 1e-9_wp*slide/film, "and rate of shear")
  end subroutine eyring_between_plates

end program test_line_shear
