/* A lubricated point contact for C programs; docs/reference/fortran.md has the table of arguments.
 *
 * Numbers in SI; fields have nx*ny entries, x changing fastest. Procedures return a status, PYWORM_OK or another one. */
#ifndef PYWORM_CONTACT_H
#define PYWORM_CONTACT_H

#ifdef __cplusplus
extern "C" {
#endif

enum pyworm_status {
    PYWORM_OK, PYWORM_BAD_ARGUMENT, PYWORM_NOT_FINITE, PYWORM_NO_PLAN, PYWORM_NOT_CONVERGED, PYWORM_NO_DESCENT,
    PYWORM_NO_MEMORY, PYWORM_INTERRUPTED, PYWORM_INACCURATE
};
enum pyworm_viscosity { PYWORM_BARUS = 1, PYWORM_ROELANDS };
enum pyworm_flow_law { PYWORM_NEWTON, PYWORM_EYRING, PYWORM_BAIR_WINER, PYWORM_EYRING_LIMITED, PYWORM_CARREAU };

struct pyworm_oil {
    int law;
    double viscosity, exponent, pole_pressure, d1, d2, temperature, thermal_exponent, expansivity, conductivity,
        heat_capacity;
};
struct pyworm_flow {
    int law;
    double stress, limit, limit_pressure, exponent;
    int levels;
};
struct pyworm_body {
    double conductivity, heat_capacity, bulk_rise;
};
/* figures, their relative errors by the grids, that of both films by the window; coarsening is the spacing of the film's
 * grid over that of the given one */
struct pyworm_found {
    double film_min, film_central, pressure_max, film_min_error, film_central_error, pressure_max_error, window_error,
        residual, load_error;
    int steps, coarsening;
};
struct pyworm_point;

int pyworm_solve_dry(int nx, int ny, const double *gap, double dx, double dy, double reduced_modulus, double load,
    double tolerance, double *p, double *approach);
/* flow and bodies (two of them) may be null */
struct pyworm_point *pyworm_setup(int nx, int ny, const double *gap, double dx, double dy, const double velocity_1[2],
    const double velocity_2[2], double reduced_modulus, double load, const struct pyworm_oil *oil,
    const struct pyworm_flow *flow, const struct pyworm_body *bodies, int *status);
/* PYWORM_INACCURATE of a film whose errors by grid and window are together above the accuracy */
int pyworm_solve(struct pyworm_point *contact, double tolerance, double accuracy, struct pyworm_found *found);
void pyworm_read(struct pyworm_point *contact, int nx, int ny, double *p, double *h, double *rise);
int pyworm_shear(struct pyworm_point *contact, int nx, int ny, double *stress_x, double *stress_y, double *heat);
void pyworm_free(struct pyworm_point *contact);
/* asked once an iteration; not zero ends the call with PYWORM_INTERRUPTED; null for nothing */
void pyworm_interrupt_by(int (*asked)(void));

#ifdef __cplusplus
}
#endif

#endif
