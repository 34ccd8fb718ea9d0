/* The straight slide for the tests of the C interface, on either precision: a bar of 0.2 kg between
 * two point fingers of 20 N, pushed by a point with 0.1 m/s^2. Without friction at the pusher it
 * takes 2 mu F + m a = 2 * 0.5 * 20 + 0.2 * 0.1 = 20.02 N. */
#ifndef SLIDE_H
#define SLIDE_H

#include "lcpush/lcpush.h"

#define SLIDE_SCENE(prefix, real, name)                                                            \
  static const prefix##_point name##_points[3] = {                                                 \
      {0, 0, (real)0.005}, {0, 0, (real)-0.005}, {(real)-0.05, 0, 0}};                             \
  static const prefix##_body name##_bodies[3] = {                                                  \
      {LCPUSH_FINGER, {0, 0, -1}, {1, 0, 0}, (real)0.5, 0, 0, 0, 1, {0}, 0},                       \
      {LCPUSH_FINGER, {0, 0, 1}, {1, 0, 0}, (real)0.5, 0, 0, 1, 1, {0}, 0},                        \
      {LCPUSH_PUSHER, {1, 0, 0}, {0, 1, 0}, 0, 0, 0, 2, 1, {(real)0.1, 0, 0, 0, 0, 0}, 0}};        \
  static const prefix##_actuator name##_actuators[2] = {{20, 0}, {20, 0}};                         \
  static const prefix##_drive name##_drives[2] = {{0, 0, {0, 0, -1, 0, 0, 0}},                     \
                                                  {1, 1, {0, 0, 1, 0, 0, 0}}};                     \
  static const prefix##_scene name = {                                                             \
      {(real)0.2, {(real)1e-4, 0, 0, 0, (real)1e-4, 0, 0, 0, (real)1e-4}, {0}},                    \
      {0, 0, 0},                                                                                   \
      4,                                                                                           \
      LCPUSH_PAD,                                                                                  \
      0,                                                                                           \
      name##_bodies,                                                                               \
      3,                                                                                           \
      name##_points,                                                                               \
      3,                                                                                           \
      name##_actuators,                                                                            \
      2,                                                                                           \
      name##_drives,                                                                               \
      2,                                                                                           \
      0}

#endif
