!> The version of the library, that of `meson.build` and `fpm.toml` (`tests/python/test_fortran_library.py`).
module pyworm_version_number
  implicit none(type, external)
  private

  character(len=*), parameter, public :: pyworm_version = '0.3.0'

end module pyworm_version_number
