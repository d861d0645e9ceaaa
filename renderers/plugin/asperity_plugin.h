/* The interface between Asperity and a force model in a plug-in: version 1.
 *
 * A plug-in is a shared library with one force model. It exports one function, asperity_plugin_model, which returns a
 * description of the model with pointers to its functions. C++ programmers use asperity_plugin.hpp, which fills in the functions from a
 * class and catches exceptions.
 *
 * Scope: a point on a plane, with a force of three components at the tip of the probe, as in the built-in point models. Asperity computes
 * everything that these models share: the place of the surface, its border, friction along the surface, and stochastic
 * resonance. The model computes the rest from the position of the tip on the texture.
 *
 * Units and frame: SI. x and y lie in the surface, z is its outward normal.
 *
 * Strings are UTF-8 and end with a zero byte. Strings and arrays of a description remain unchanged while the plug-in is loaded.
 *
 * Threads: Asperity calls the functions of one renderer from one thread at a time, those of several renderers at the same time from
 * several threads.
 *
 * Versions: a plug-in is loaded only if its abi_version is that of the program. Any change of this file that is not a comment
 * increases the version. */

#ifndef ASPERITY_PLUGIN_H
#define ASPERITY_PLUGIN_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#define ASPERITY_PLUGIN_ABI_VERSION 1u

/* The kinds of a parameter. The value of a choice is its place among the choices, from 0. */
#define ASPERITY_NUMBER 0u
#define ASPERITY_INTEGER 1u
#define ASPERITY_CHOICE 2u

/* A parameter of the model: declared once, for protocols, the command line, exports and forms. */
typedef struct asperity_parameter {
  const char* name;    /* [a-z][A-Za-z0-9_]*, ends in its unit: "amplitude_m", "stiffness_N_per_m" */
  uint32_t kind;       /* ASPERITY_NUMBER, ASPERITY_INTEGER or ASPERITY_CHOICE */
  const char* unit;    /* "m", "N/m", as at the end of the name; "1" for a number without unit and for a choice */
  double minimum;      /* inclusive; not used for a choice */
  double maximum;      /* inclusive; not used for a choice */
  double default_value;
  const char* const* choices; /* null except for a choice */
  uint32_t choice_count;
  const char* meaning; /* a phrase: "Amplitude A: half the height from trough to crest" */
} asperity_parameter;

/* The height and its slopes at a point of a height field. */
typedef struct asperity_height {
  double height_m;
  double slope_x; /* dh/dx */
  double slope_y; /* dh/dy */
} asperity_height;

/* A relief. Real-time: `sample` may be called in a tick. */
typedef struct asperity_height_field {
  const void* field; /* the first argument of `sample` */
  void (*sample)(const void* field, double x_m, double y_m, asperity_height* height);
  double pitch_m;   /* between neighbouring samples: the shortest wavelength is 2 pitch_m */
  double minimum_m; /* the lowest and the highest sample */
  double maximum_m;
} asperity_height_field;

/* From what a renderer is made. Valid during the call that receives it; the height field until the renderer is destroyed. */
typedef struct asperity_inputs {
  const double* values; /* of the parameters, in the order of their declarations; complete and within their limits */
  uint32_t value_count;
  double stiffness_N_per_m; /* of the surface, positive */
  double motion_scale;      /* distance on the texture per distance of the probe: slopes along the motion include it */
  uint64_t seed;            /* of all random numbers of the model */
  const asperity_height_field* height_field; /* null unless the model needs one */
} asperity_inputs;

/* The tip of the probe in one tick. */
typedef struct asperity_sample {
  double x_m; /* on the texture: motion_scale (position - centre of the patch) + origin of the texture */
  double y_m;
  double height_m;            /* of the tip above the plane of the surface; negative below */
  double velocity_m_per_s[3]; /* of the probe, without motion_scale */
  double dt_s;                /* since the previous tick, positive; 0 in `reset` */
} asperity_sample;

/* The result of a tick. In free space all are 0. */
typedef struct asperity_force {
  double force_N[3];    /* of the surface on the hand, without friction; begins at 0 with the depth, so that contact is not a blow */
  double normal_N;      /* the normal force from which friction is computed, of a law of Coulomb force_N[2]; not negative */
  double penetration_m; /* depth of the tip in the surface, texture included; 0 exactly if there is no contact */
} asperity_force;

/* The highest frequency of the texture: in waves per metre of the probe's path (motion_scale included), and in hertz for a texture
 * that depends on time. */
typedef struct asperity_band {
  double per_m;
  double time_Hz;
} asperity_band;

/* A force model. Functions that return int return 0 for success; any other value is an error. */
typedef struct asperity_model {
  uint32_t abi_version;   /* ASPERITY_PLUGIN_ABI_VERSION, always the first member */
  const char* id;         /* [a-z][a-z0-9_]*: the name in protocols; not that of a built-in model */
  const char* version;    /* changes whenever the same inputs give another force; stored with every trial */
  const char* summary;    /* one line */
  const char* source;     /* the publication of the law, or its author */
  const asperity_parameter* parameters;
  uint32_t parameter_count;
  /* The one parameter that scales only the texture: a number with the minimum 0. At 0 the model is the plate without texture,
   * force = stiffness_N_per_m * depth along +z. */
  const char* amplitude_parameter;
  uint32_t needs_height_field;  /* 1 or 0 */
  uint32_t feels_applied_force; /* 1 if the texture depends on how hard the hand presses */
  uint32_t is_conservative;     /* 1 if the force is the gradient of a potential for all values */
  uint32_t moves_by_itself;     /* 1 if the force on a probe at rest keeps changing */
  const char* band_formula;     /* `band` in hertz as text, with v the speed of the hand in m/s: "v/wavelength_m" */

  int (*band)(const asperity_inputs* inputs, asperity_band* band);

  /* Makes a renderer, outside real-time code: it may allocate and tabulate. Null for inputs that the model refuses; it then writes
   * a message with its terminating zero byte into `message`, which has `message_size` bytes. */
  void* (*create)(const asperity_inputs* inputs, char* message, size_t message_size);
  void (*destroy)(void* renderer);

  /* Real-time: `reset` and `tick` must not allocate, lock, block or throw. Their results depend only on the inputs of `create` and
   * on the samples since `reset`, not on a clock or on global state. `reset` comes before the first `tick` and clears all
   * state. On a plane `tick` is called in every tick of a presentation, in free space and outside the patch as well. On a body there
   * are three renderers, one for each axis along which the texture is projected: each has a `tick` only while its projection
   * is in use near the surface, and a `reset`, in real time, whenever it comes into use. An error, or a number that is not finite, sets the force to zero until the surface is presented again. */
  int (*reset)(void* renderer, const asperity_sample* first);
  int (*tick)(void* renderer, const asperity_sample* sample, asperity_force* force);

  /* The message of the last error of this renderer in `reset` or `tick`; null or empty for none. May itself be null. */
  const char* (*message)(const void* renderer);
} asperity_model;

#if defined(__GNUC__)
#define ASPERITY_PLUGIN_EXPORT __attribute__((visibility("default")))
#else
#define ASPERITY_PLUGIN_EXPORT
#endif

/* Defined by the plug-in. Returns the same description whenever it is called. */
ASPERITY_PLUGIN_EXPORT const asperity_model* asperity_plugin_model(void);

#ifdef __cplusplus
}
#endif

#endif
