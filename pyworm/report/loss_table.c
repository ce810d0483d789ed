/* Losses of a worm gear set by a table, as a functional mock-up unit (FMI 3.0, co-simulation).

   Made by pyworm from @NAME@. The inputs are speed and torque of the worm and the temperature of the oil; between
   the points of the table values are linear, beyond its ends they are those of the end. The unit has no state
   but its inputs: outputs are those of the inputs at the end of a step. */

#include <math.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#if defined(_WIN32)
#define EXPORT __declspec(dllexport)
#else
#define EXPORT __attribute__((visibility("default")))
#endif

typedef enum { OK, WARNING, DISCARD, ERROR, FATAL } Status;
typedef uint32_t Reference;

@TABLE@

enum { SPEED = 1, TORQUE, TEMPERATURE };
enum { EFFICIENCY = 4, REVERSE_EFFICIENCY, FRICTION_TORQUE, OUTPUT_TORQUE, TRANSMISSION_ERROR, STIFFNESS };
enum { LOCKED = 10, OUTSIDE };
enum { MAX_PASSES = 200 };

typedef struct {
  double time;
  double values[STIFFNESS + 1];
  bool locked, outside;
} Unit;

/* Number of the interval of rising values that holds a value, and its place there, 0 to 1. */
static int interval(const double *axis, int count, double value, double *place, bool *outside) {
  int left = 0;
  *place = 0.0;
  if (value < axis[0] || value > axis[count - 1]) *outside = true;
  if (count == 1 || !(value > axis[0])) return 0;
  if (value >= axis[count - 1]) {
    *place = 1.0;
    return count - 2;
  }
  while (value >= axis[left + 1]) left++;
  *place = (value - axis[left]) / (axis[left + 1] - axis[left]);
  return left;
}

/* A quantity of the table at a speed, a torque of the wheel and a temperature. */
static double looked_up(const double *table, const double *at, bool *outside) {
  static const double *const axes[3] = {speeds, torques, temperatures};
  static const int counts[3] = {SPEEDS, TORQUES, TEMPERATURES};
  int first[3];
  double place[3], sum = 0.0;
  for (int axis = 0; axis < 3; axis++)
    first[axis] = interval(axes[axis], counts[axis], at[axis], &place[axis], outside);
  for (int corner = 0; corner < 8; corner++) {
    double weight = 1.0;
    int index = 0;
    for (int axis = 0; axis < 3; axis++) {
      int up = corner >> axis & 1;
      weight *= up ? place[axis] : 1.0 - place[axis];
      index = index * counts[axis] + (first[axis] + up < counts[axis] ? first[axis] + up : first[axis]);
    }
    sum += weight * table[index];
  }
  return sum;
}

/* Outputs of the inputs; the torque of the wheel, by which the table goes, follows by repeated use of it. With
   torque against the speed the wheel drives: its torque makes up for the losses, none does where it locks. */
static void compute(Unit *unit) {
  double *value = unit->values;
  double input = fabs(value[TORQUE]), sign = value[TORQUE] < 0.0 ? -1.0 : 1.0;
  double at[3] = {fabs(value[SPEED]), RATIO * input, value[TEMPERATURE]};
  double efficiency = 1.0, passed = input;
  bool braking = value[SPEED] * value[TORQUE] < 0.0;
  for (int pass = 0; pass < MAX_PASSES; pass++) {
    double before = at[1];
    bool ignored = false;
    double other = looked_up(other_torque, at, &ignored);
    efficiency = looked_up(efficiencies, at, &ignored);
    if (braking) {
      double reverse = looked_up(reverse_efficiencies, at, &ignored);
      passed = reverse > 0.0 ? (input + other) / reverse : 0.0;
    } else {
      passed = input > other ? efficiency * (input - other) : 0.0;
    }
    at[1] = RATIO * passed;
    if (fabs(at[1] - before) <= 1e-15 * at[1]) break;
  }
  unit->outside = false;
  value[REVERSE_EFFICIENCY] = looked_up(reverse_efficiencies, at, &unit->outside);
  value[TRANSMISSION_ERROR] = looked_up(transmission_errors, at, &unit->outside);
  value[STIFFNESS] = looked_up(stiffnesses, at, &unit->outside);
  value[EFFICIENCY] = efficiency;
  value[OUTPUT_TORQUE] = sign * RATIO * passed;
  value[FRICTION_TORQUE] = braking ? passed - input : input - passed;
  unit->locked = !(value[REVERSE_EFFICIENCY] > 0.0);
}

static void reset(Unit *unit) {
  memset(unit, 0, sizeof *unit);
  unit->values[SPEED] = speeds[0];
  unit->values[TORQUE] = torques[0] / RATIO;
  unit->values[TEMPERATURE] = temperatures[0];
  compute(unit);
}

EXPORT const char *fmi3GetVersion(void) { return "3.0"; }

EXPORT Status fmi3SetDebugLogging(void *instance, bool on, size_t count, const char *const *categories) {
  (void)instance, (void)on, (void)count, (void)categories;
  return OK;
}

EXPORT void *fmi3InstantiateCoSimulation(const char *name, const char *token, const char *resources,
                                         bool visible, bool logging, bool events, bool early,
                                         const Reference *intermediate, size_t count, void *environment,
                                         void *log_message, void *intermediate_update) {
  (void)name, (void)resources, (void)visible, (void)logging, (void)events, (void)early;
  (void)intermediate, (void)count, (void)environment, (void)log_message, (void)intermediate_update;
  Unit *unit = token && strcmp(token, TOKEN) == 0 ? malloc(sizeof *unit) : NULL;
  if (unit) reset(unit);
  return unit;
}

EXPORT void fmi3FreeInstance(void *instance) { free(instance); }

EXPORT Status fmi3EnterInitializationMode(void *instance, bool tolerance_defined, double tolerance,
                                          double start, bool stop_defined, double stop) {
  (void)tolerance_defined, (void)tolerance, (void)stop_defined, (void)stop;
  ((Unit *)instance)->time = start;
  return OK;
}

EXPORT Status fmi3ExitInitializationMode(void *instance) {
  compute(instance);
  return OK;
}

EXPORT Status fmi3Terminate(void *instance) {
  (void)instance;
  return OK;
}

EXPORT Status fmi3Reset(void *instance) {
  reset(instance);
  return OK;
}

EXPORT Status fmi3GetFloat64(void *instance, const Reference *references, size_t count, double *values,
                             size_t value_count) {
  Unit *unit = instance;
  if (value_count != count) return ERROR;
  compute(unit);
  for (size_t i = 0; i < count; i++) {
    if (references[i] > STIFFNESS) return ERROR;
    values[i] = references[i] == 0 ? unit->time : unit->values[references[i]];
  }
  return OK;
}

EXPORT Status fmi3SetFloat64(void *instance, const Reference *references, size_t count, const double *values,
                             size_t value_count) {
  Unit *unit = instance;
  if (value_count != count) return ERROR;
  for (size_t i = 0; i < count; i++) {
    if (references[i] < SPEED || references[i] > TEMPERATURE || !isfinite(values[i])) return ERROR;
    unit->values[references[i]] = values[i];
  }
  return OK;
}

EXPORT Status fmi3GetBoolean(void *instance, const Reference *references, size_t count, bool *values,
                             size_t value_count) {
  Unit *unit = instance;
  if (value_count != count) return ERROR;
  compute(unit);
  for (size_t i = 0; i < count; i++) {
    if (references[i] != LOCKED && references[i] != OUTSIDE) return ERROR;
    values[i] = references[i] == LOCKED ? unit->locked : unit->outside;
  }
  return OK;
}

EXPORT Status fmi3DoStep(void *instance, double time, double step, bool no_earlier_state, bool *event,
                         bool *terminate, bool *early_return, double *last_time) {
  Unit *unit = instance;
  (void)no_earlier_state;
  unit->time = time + step;
  compute(unit);
  *event = *terminate = *early_return = false;
  *last_time = unit->time;
  return OK;
}

/* What the unit cannot do by its description; only the first argument is looked at. */
#define CANNOT(name) \
  EXPORT Status fmi3##name(void *instance) { \
    (void)instance; \
    return ERROR; \
  }

@UNSUPPORTED@
EXPORT void *fmi3InstantiateModelExchange(void) { return NULL; }
EXPORT void *fmi3InstantiateScheduledExecution(void) { return NULL; }
