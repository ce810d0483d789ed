program test_line_film
  use tap, only: done
  implicit none(type, external)
  call done()
end program test_line_film
