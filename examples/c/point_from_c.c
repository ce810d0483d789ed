/* The isothermal film of a steel ball on a steel disc, from C. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include "pyworm_contact.h"

#define N 129

int main(void) {
    static double gap[N * N];
    const double radius = 0.01, load = 20.0, modulus = 230e9, a = cbrt(3 * load * radius / (2 * modulus));
    const struct pyworm_scene scene = {
        .nx = N, .ny = N, .dx = 6 * a / (N - 1), .dy = 5 * a / (N - 1), .load = load, .reduced_modulus = modulus,
        .velocity_1 = {1.0, 0.0}, .velocity_2 = {1.0, 0.0}, .gap = gap,
    };
    const struct pyworm_oil oil = {
        .law = PYWORM_ROELANDS, .viscosity = 0.04, .exponent = 0.6, .pole_pressure = 1.96e8, .d1 = 0.6e-9, .d2 = 1.7e-9,
    };
    const struct pyworm_options options = {.tolerance = 1e-6, .accuracy = 0.1, .most_steps = 60};
    struct pyworm_found found;
    int status;

    for (int j = 0; j < N; j++)
        for (int i = 0; i < N; i++) {
            const double x = -4.2 * a + i * scene.dx, y = -2.5 * a + j * scene.dy;
            gap[j * N + i] = (x * x + y * y) / (2 * radius);
        }
    struct pyworm_film *film = pyworm_setup(&scene, &oil, NULL, NULL, NULL, &status);
    if (status == PYWORM_OK) status = pyworm_solve(film, &options, &found);
    pyworm_free(film);
    if (status != PYWORM_OK) {
        fprintf(stderr, "pyworm %s: %s\n", pyworm_version(), pyworm_message(status));
        return EXIT_FAILURE;
    }
    printf("minimum film [nm]       %8.2f\nmaximum pressure [MPa]  %8.2f\n", found.film_min * 1e9, found.pressure_max / 1e6);
    printf("error by the grid [%%]   %8.2f\n", 100 * found.film_min_error);
    printf("error by the window [%%] %8.2f\n", 100 * found.window_error);
    return EXIT_SUCCESS;
}
