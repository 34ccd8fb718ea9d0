/* Shipped scenes (fixtures/scenes) as tables in flash, in the precision that device.h chooses. A
 * test compares their answers with those of the files. */
#ifndef SCENES_H
#define SCENES_H

#include "device.h"

/* squeeze.toml: a box between a thumb that moves and a finger that presses, no friction. */
static const LCPUSH(point) squeeze_points[2] = {{R(0.02), 0, 0}, {R(-0.02), 0, 0}};
static const LCPUSH(body) squeeze_bodies[2] = {
    {LCPUSH_FINGER, {-1, 0, 0}, {0, 1, 0}, 0, 0, 0, 0, 1, {0, 0, 0, 0, 0, 0}, 0},
    {LCPUSH_PUSHER, {1, 0, 0}, {0, 1, 0}, 0, 0, 0, 1, 1, {1, 0, 0, 0, 0, 0}, 0}};
static const LCPUSH(actuator) squeeze_actuators[1] = {{5, 0}};
static const LCPUSH(drive) squeeze_drives[1] = {{0, 0, {-1, 0, 0, 0, 0, 0}}};
static const LCPUSH(scene) squeeze = {{1, BOX(1, 0.04, 0.02, 0.02), {0}},
                                      {0, 0, 0},
                                      4,
                                      LCPUSH_RIGID,
                                      1,
                                      squeeze_bodies,
                                      2,
                                      squeeze_points,
                                      2,
                                      squeeze_actuators,
                                      1,
                                      squeeze_drives,
                                      1,
                                      0};

/* soft_fingers.toml: two point fingers that also resist twisting, a rod off their axis. */
static const LCPUSH(point) soft_points[3] = {
    {0, 0, R(0.005)}, {0, 0, R(-0.005)}, {R(-0.05), R(0.00346410161513775), 0}};
static const LCPUSH(body) soft_bodies[3] = {
    {LCPUSH_FINGER, {0, 0, -1}, {1, 0, 0}, R(0.5), R(0.006), 0, 0, 1, {0, 0, 0, 0, 0, 0}, 0},
    {LCPUSH_FINGER, {0, 0, 1}, {1, 0, 0}, R(0.5), R(0.006), 0, 1, 1, {0, 0, 0, 0, 0, 0}, 0},
    {LCPUSH_PUSHER, {1, 0, 0}, {0, 1, 0}, 0, 0, 0, 2, 1, {R(0.1), 0, 0, 0, 0, 0}, 0}};
static const LCPUSH(actuator) grip_of_20[2] = {{20, 0}, {20, 0}};
static const LCPUSH(drive) pinch[2] = {{0, 0, {0, 0, -1, 0, 0, 0}}, {1, 1, {0, 0, 1, 0, 0, 0}}};
static const LCPUSH(scene) soft_fingers = {{R(0.2), BOX(0.2, 0.1, 0.03, 0.01), {0}},
                                           {0, 0, 0},
                                           8,
                                           LCPUSH_PAD,
                                           0,
                                           soft_bodies,
                                           3,
                                           soft_points,
                                           3,
                                           grip_of_20,
                                           2,
                                           pinch,
                                           2,
                                           0};

/* straight_slide.toml: fingertips of four points, a straight edge pushes. */
static const LCPUSH(point) slide_points[10] = {{R(0.005), 0, R(0.005)},   {0, R(0.005), R(0.005)},
                                               {R(-0.005), 0, R(0.005)},  {0, R(-0.005), R(0.005)},
                                               {R(0.005), 0, R(-0.005)},  {0, R(0.005), R(-0.005)},
                                               {R(-0.005), 0, R(-0.005)}, {0, R(-0.005), R(-0.005)},
                                               {R(-0.05), R(-0.015), 0},  {R(-0.05), R(0.015), 0}};
static const LCPUSH(body) slide_bodies[3] = {
    {LCPUSH_FINGER, {0, 0, -1}, {1, 0, 0}, R(0.5), 0, 0, 0, 4, {0, 0, 0, 0, 0, 0}, 0},
    {LCPUSH_FINGER, {0, 0, 1}, {1, 0, 0}, R(0.5), 0, 0, 4, 4, {0, 0, 0, 0, 0, 0}, 0},
    {LCPUSH_PUSHER, {1, 0, 0}, {0, 1, 0}, R(0.3), 0, 0, 8, 2, {R(0.1), 0, 0, 0, 0, 0}, 0}};
static const LCPUSH(scene) straight_slide = {{R(0.2), BOX(0.2, 0.1, 0.03, 0.01), {0}},
                                             {0, R(-9.81), 0},
                                             8,
                                             LCPUSH_PAD,
                                             0,
                                             slide_bodies,
                                             3,
                                             slide_points,
                                             10,
                                             grip_of_20,
                                             2,
                                             pinch,
                                             2,
                                             0};

/* rolling.toml: a cylinder in a parallel jaw, one actuator for both fingers, on a sheet. */
static const LCPUSH(point) rolling_points[6] = {{R(-0.02), 0, R(-0.02)}, {R(-0.02), 0, R(0.02)},
                                                {R(0.02), 0, R(-0.02)},  {R(0.02), 0, R(0.02)},
                                                {0, R(-0.02), R(-0.02)}, {0, R(-0.02), R(0.02)}};
static const LCPUSH(body) rolling_bodies[3] = {
    {LCPUSH_FINGER, {1, 0, 0}, {0, 0, 0}, R(0.3), 0, 0, 0, 2, {0, 0, 0, 0, 0, 0}, 0},
    {LCPUSH_FINGER, {-1, 0, 0}, {0, 0, 0}, R(0.3), 0, 0, 2, 2, {0, 0, 0, 0, 0, 0}, 0},
    {LCPUSH_PUSHER, {0, 1, 0}, {0, 0, 0}, R(0.5), 0, 0, 4, 2, {R(0.1), 0, 0, 0, 0, 0}, 0}};
static const LCPUSH(actuator) rolling_actuators[1] = {{8, 0}};
static const LCPUSH(drive) rolling_drives[2] = {{0, 0, {1, 0, 0, 0, 0, 0}},
                                                {1, 0, {-1, 0, 0, 0, 0, 0}}};
static const LCPUSH(scene) rolling = {{R(0.5), CYLINDER(0.5, 0.02, 0.06), {0}},
                                      {0, R(-9.81), 0},
                                      8,
                                      LCPUSH_PAD,
                                      0,
                                      rolling_bodies,
                                      3,
                                      rolling_points,
                                      6,
                                      rolling_actuators,
                                      1,
                                      rolling_drives,
                                      2,
                                      0};

#endif
