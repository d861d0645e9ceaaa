// The faces of textured bodies over the window of a contact, and their heights, on a compute device.
//
// The arithmetic is that of reference_penetration.cpp, operation by operation, in double precision. SURFACES and the structs
// that the host names are repeated in device_task.h, the sizes of groups in gpu_penetration.cpp. penetration.cl continues this file: the
// driver compiles both as one text.
//
// A "surface" of a contact is B (0), A at its pose (1), or A in one of the ten configurations of the differences
// (2 to 11).

#pragma OPENCL EXTENSION cl_khr_fp64 : enable
#pragma OPENCL FP_CONTRACT OFF

#define SURFACES 12
#define TILE 16
#define GROUP 64                            // work items of a tile
#define ROWS (GROUP / TILE)                 // that they take at once
#define PER_ITEM (TILE * TILE / GROUP)      // samples of a work item: one column, every fourth row
#define STEEPEST_COSINE 0.02  // kSteepest_cosine of contact_geometry.h
#define WEIGH_GROUP 256
#define RATES 5
#define BOUND_SLACK 1e-6  // of the sizes in an upper bound, far above the rounding of a face that has one
#define SUMS 12

typedef struct {
  double frame[12];             // origin, u, v, n
  double poses[SURFACES][12];   // rotation by columns, position
  double spacing_m;
  double width_m;
  double leaning[2];            // cosines of B and A
  double tau_m;                 // 0: hard maximum
  int samples;
  int used_surfaces;            // 12, or 2 for the smooth maximum
  int first[2];                 // of the lists of triangles of B and A
  int count[2];
  int first_face;               // of this contact
  int padding;
} Task;

typedef struct {
  double depth_m[SURFACES];     // [0] unused; NaN where nothing is covered
  double height_m;              // of A at the deepest sample
  double sums[SUMS];            // of the smooth maximum: weight, weight·log, weight·rates, weight·log·rates
  int sample;
  int covered;
  int folded;
  int at_border;
} Answer;

// One corner of a surface's triangle.
typedef struct {
  double point_m[3];
  double normal[3];
  double place[2];
  int vertex;
  int padding;
} Corner;

// The edge opposite a corner, from its vertex with the lower number; both faces of an edge have the same one.
typedef struct {
  double from_x, from_y;
  double along_x, along_y;
  double area;                  // of the face, with the sign that makes the weight of the corner inside it positive
} Edge;

// A face over the window of its contact, with the ranges of samples within its bounds.
typedef struct {
  Edge edges[3];
  double z[3], normal_z[3], place_x[3], place_y[3];
  double x[3], y[3], normal_x[3], normal_y[3];  // for the rates
  double area;
  double top, top_x, top_y;     // an upper bound of the height outwards: top + top_x·x + top_y·y
  int first_row, last_row, first_column, last_column;
} Face;

double place_m(int i, __global const Task* task) {
  return (i - 0.5 * (task->samples - 1)) * task->spacing_m;
}

double along(__global const double* axis, double x, double y, double z) {
  return axis[0] * x + axis[1] * y + axis[2] * z;
}

// The first and last of the samples between two positions.
int2 samples_between(__global const Task* task, double low_m, double high_m) {
  const double middle = 0.5 * (task->samples - 1);
  const double last = task->samples - 1.0;
  const double first = clamp(ceil(low_m / task->spacing_m + middle), 0.0, last + 1.0);
  const double end = clamp(floor(high_m / task->spacing_m + middle), -1.0, last);
  return (int2)((int)first, (int)end);
}

// The amount by which a leaning face is lowered (sunk_m of contact_geometry.h); infinite where it is left out.
double sunk_m(double cosine, double leaning, double window_m) {
  if (cosine >= leaning) return 0.0;
  const double left = cosine - 0.5 * leaning;
  if (left <= 0.0) return INFINITY;
  return 0.5 * window_m * (leaning - cosine) / left;
}

// The plane of the face, and above it its highest displacement. Where the face is too narrow for its plane to be exact,
// there is no bound.
void set_top(__global Face* face, const double* x, const double* y, const double* z, const double* lean, double area,
             double outwards, double peak_m, double width_m) {
  if (!(fabs(area) > 1e-9 * width_m * width_m)) {
    face->top = INFINITY;
    face->top_x = 0.0;
    face->top_y = 0.0;
    return;
  }
  const double slope_x = outwards * ((z[1] - z[0]) * (y[2] - y[0]) - (z[2] - z[0]) * (y[1] - y[0])) / area;
  const double slope_y = outwards * ((z[2] - z[0]) * (x[1] - x[0]) - (z[1] - z[0]) * (x[2] - x[0])) / area;
  const double leaning = fmax(fabs(lean[0]), fmax(fabs(lean[1]), fabs(lean[2])));
  const double size = fmax(fabs(z[0]), fmax(fabs(z[1]), fabs(z[2]))) +
                      (fabs(slope_x) + fabs(slope_y)) * (width_m + fabs(x[0]) + fabs(y[0]));
  face->top = outwards * z[0] - slope_x * x[0] - slope_y * y[0] + peak_m * leaning + BOUND_SLACK * (size + peak_m);
  face->top_x = slope_x;
  face->top_y = slope_y;
}

// One work item: one triangle of one surface of one contact.
__kernel void prepare_faces(__global const Task* restrict tasks, int contacts,
                            __global const Corner* restrict corners_b, __global const Corner* restrict corners_a,
                            double peak_b_m, double peak_a_m, __global Face* restrict faces) {
  const int t = get_global_id(0);
  const int surface = get_global_id(1);
  __global const Task* task = tasks + get_global_id(2);
  const int body = surface == 0 ? 0 : 1;
  if (surface >= task->used_surfaces || t >= task->count[body]) return;
  __global const int* lists = (__global const int*)(tasks + contacts);
  __global const Corner* corners = (body == 0 ? corners_b : corners_a) + 3 * lists[task->first[body] + t];
  // The faces of B, then those of A for each of its configurations.
  __global Face* face = faces + task->first_face + t +
                        (surface == 0 ? 0 : task->count[0] + (surface - 1) * task->count[1]);
  __global const double* turn = task->poses[surface];
  const double outwards = body == 0 ? 1.0 : -1.0;
  double x[3], y[3], z[3], lean[3];
  for (int i = 0; i < 3; ++i) {
    __global const double* p = corners[i].point_m;
    __global const double* d = corners[i].normal;
    const double at_x = (turn[0] * p[0] + turn[3] * p[1] + turn[6] * p[2]) + turn[9] - task->frame[0];
    const double at_y = (turn[1] * p[0] + turn[4] * p[1] + turn[7] * p[2]) + turn[10] - task->frame[1];
    const double at_z = (turn[2] * p[0] + turn[5] * p[1] + turn[8] * p[2]) + turn[11] - task->frame[2];
    x[i] = along(task->frame + 3, at_x, at_y, at_z);
    y[i] = along(task->frame + 6, at_x, at_y, at_z);
    z[i] = along(task->frame + 9, at_x, at_y, at_z);
    const double n_x = turn[0] * d[0] + turn[3] * d[1] + turn[6] * d[2];
    const double n_y = turn[1] * d[0] + turn[4] * d[1] + turn[7] * d[2];
    const double n_z = turn[2] * d[0] + turn[5] * d[1] + turn[8] * d[2];
    face->normal_x[i] = along(task->frame + 3, n_x, n_y, n_z);
    face->normal_y[i] = along(task->frame + 6, n_x, n_y, n_z);
    lean[i] = along(task->frame + 9, n_x, n_y, n_z);
    face->normal_z[i] = lean[i];
    face->place_x[i] = corners[i].place[0];
    face->place_y[i] = corners[i].place[1];
  }
  const double3 e1 = (double3)(x[1] - x[0], y[1] - y[0], z[1] - z[0]);
  const double3 e2 = (double3)(x[2] - x[0], y[2] - y[0], z[2] - z[0]);
  const double3 normal = (double3)(e1.y * e2.z - e2.y * e1.z, e1.z * e2.x - e2.z * e1.x, e1.x * e2.y - e2.x * e1.y);
  const double length_of = sqrt(normal.x * normal.x + normal.y * normal.y + normal.z * normal.z);
  const double facing = outwards * normal.z;
  const double sunk = facing > 0.0 ? sunk_m(facing / length_of, task->leaning[body], task->width_m) : INFINITY;
  if (!(facing > STEEPEST_COSINE * length_of) || !isfinite(sunk)) {
    face->first_row = 1;
    face->last_row = 0;
    face->first_column = 1;
    face->last_column = 0;
    return;
  }
  const double area = (x[1] - x[0]) * (y[2] - y[0]) - (y[1] - y[0]) * (x[2] - x[0]);
  face->area = area;
  for (int i = 0; i < 3; ++i) {
    z[i] -= outwards * sunk;
    face->x[i] = x[i];
    face->y[i] = y[i];
    face->z[i] = z[i];
    const int next = (i + 1) % 3, after = (i + 2) % 3;
    const bool is_ordered = corners[next].vertex < corners[after].vertex;
    const int from = is_ordered ? next : after, to = is_ordered ? after : next;
    face->edges[i].from_x = x[from];
    face->edges[i].from_y = y[from];
    face->edges[i].along_x = x[to] - x[from];
    face->edges[i].along_y = y[to] - y[from];
    face->edges[i].area = is_ordered ? area : -area;
  }
  set_top(face, x, y, z, lean, area, outwards, body == 0 ? peak_b_m : peak_a_m, task->width_m);
  const int2 columns = samples_between(task, fmin(x[0], fmin(x[1], x[2])), fmax(x[0], fmax(x[1], x[2])));
  const int2 rows = samples_between(task, fmin(y[0], fmin(y[1], y[2])), fmax(y[0], fmax(y[1], y[2])));
  face->first_row = rows.x;
  face->last_row = rows.y;
  face->first_column = columns.x;
  face->last_column = columns.y;
}

typedef struct {
  __global const short* values;
  int rows;
  int columns;
  double step_m;
} Atlas;

// A texel's cell in one direction, and the position inside it. The last texel belongs to the cell before it.
int cell_of(double at, int texels, double* inside) {
  const double last = texels - 1.0;
  const double held = clamp(at, 0.0, last);
  const double start = fmin(floor(held), fmax(0.0, last - 1.0));
  *inside = held - start;
  return (int)start;
}

double texel_m(const Atlas* atlas, int row, int column) {
  return atlas->step_m * atlas->values[row * atlas->columns + column];
}

// The displacement, and its slope per texel.
double displacement_m(const Atlas* atlas, double place_x, double place_y, double2* slope) {
  double x, y;
  const int column = cell_of(place_x, atlas->columns, &x);
  const int row = cell_of(place_y, atlas->rows, &y);
  const int right = min(column + 1, atlas->columns - 1);
  const int below = min(row + 1, atlas->rows - 1);
  const double upper_left = texel_m(atlas, row, column);
  const double upper_right = texel_m(atlas, row, right);
  const double lower_left = texel_m(atlas, below, column);
  const double lower_right = texel_m(atlas, below, right);
  const double upper = upper_left + x * (upper_right - upper_left);
  const double lower = lower_left + x * (lower_right - lower_left);
  *slope = (double2)((1.0 - y) * (upper_right - upper_left) + y * (lower_right - lower_left), lower - upper);
  return upper + y * (lower - upper);
}

// False outside the face; otherwise the weights of its corners. Both faces of an edge compute the same number for it,
// with opposite signs.
bool weigh_corners(__global const Face* face, double x, double y, double* weights) {
  bool is_inside = true;
  for (int i = 0; i < 3; ++i) {
    __global const Edge* edge = &face->edges[i];
    weights[i] = edge->along_x * (y - edge->from_y) - edge->along_y * (x - edge->from_x);
    is_inside = is_inside && !(edge->area > 0.0 ? weights[i] < 0.0 : weights[i] > 0.0);
  }
  if (!is_inside) return false;
  for (int i = 0; i < 3; ++i) weights[i] /= face->edges[i].area;
  return true;
}

double mixed(__global const double* corners, const double* weights) {
  return ((0.0 + weights[0] * corners[0]) + weights[1] * corners[1]) + weights[2] * corners[2];
}

double height_of(__global const Face* face, const Atlas* atlas, const double* weights) {
  double2 slope;
  return mixed(face->z, weights) +
         displacement_m(atlas, mixed(face->place_x, weights), mixed(face->place_y, weights), &slope) *
             mixed(face->normal_z, weights);
}

// ∂h/∂q for motions along u and v and about u, v and n (Face::rates of the reference).
void rates_of(__global const Face* face, const Atlas* atlas, const double* weights, double* rates) {
  const double p_x = mixed(face->x, weights);
  const double p_y = mixed(face->y, weights);
  const double p_z = mixed(face->z, weights);
  const double n_x = mixed(face->normal_x, weights);
  const double n_y = mixed(face->normal_y, weights);
  const double n_z = mixed(face->normal_z, weights);
  double2 d_slope;
  const double d = displacement_m(atlas, mixed(face->place_x, weights), mixed(face->place_y, weights), &d_slope);
  double slope_x = 0.0, slope_y = 0.0;
  for (int i = 0; i < 3; ++i) {
    const int from = (i + 1) % 3, to = (i + 2) % 3;
    const double height = face->z[i] + d * face->normal_z[i] +
                          (d_slope.x * face->place_x[i] + d_slope.y * face->place_y[i]) * n_z;
    slope_x += -(face->y[to] - face->y[from]) / face->area * height;
    slope_y += (face->x[to] - face->x[from]) / face->area * height;
  }
  rates[0] = -slope_x;
  rates[1] = -slope_y;
  rates[2] = p_y + d * n_y + p_z * slope_y;
  rates[3] = -p_x - d * n_x - p_z * slope_x;
  rates[4] = p_y * slope_x - p_x * slope_y;
}

