// The penetration depth of several contacts and its gradient, for all samples and configurations in parallel.
//
// The arithmetic is that of reference_penetration.cpp, operation by operation, in double precision. Results do not
// depend on the order in which work groups run: maxima are ordered by depth and then by sample, and sums have a fixed
// order within a group and over the groups.
//
// A "surface" of a contact is B (0), A at its pose (1), or A in one of the ten configurations of the differences
// (2 to 11). SURFACES, TILE and the two structs of the interface are repeated in gpu_penetration.cpp.

#pragma OPENCL EXTENSION cl_khr_fp64 : enable
#pragma OPENCL FP_CONTRACT OFF

#define SURFACES 12
#define TILE 16
#define GROUP 256
#define STEEPEST_COSINE 0.02  // kSteepest_cosine of contact_geometry.h
#define RATES 5
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

// A face over the window of its contact, with the ranges of samples within its bounds.
typedef struct {
  double x[3], y[3], z[3], normal_z[3], place_x[3], place_y[3];
  double normal_x[3], normal_y[3];
  double area;
  int vertex[3];
  int first_row, last_row, first_column, last_column;
  int padding;
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

// One work item: one triangle of one surface of one contact.
__kernel void prepare_faces(__global const Task* tasks, __global const int* lists, __global const Corner* corners_b,
                            __global const Corner* corners_a, __global Face* faces) {
  const int t = get_global_id(0);
  const int surface = get_global_id(1);
  __global const Task* task = tasks + get_global_id(2);
  const int body = surface == 0 ? 0 : 1;
  if (surface >= task->used_surfaces || t >= task->count[body]) return;
  __global const Corner* corners = (body == 0 ? corners_b : corners_a) + 3 * lists[task->first[body] + t];
  // The faces of B, then those of A for each of its configurations.
  __global Face* face = faces + task->first_face + t +
                        (surface == 0 ? 0 : task->count[0] + (surface - 1) * task->count[1]);
  __global const double* turn = task->poses[surface];
  const double outwards = body == 0 ? 1.0 : -1.0;
  double x[3], y[3], z[3];
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
    face->normal_z[i] = along(task->frame + 9, n_x, n_y, n_z);
    face->place_x[i] = corners[i].place[0];
    face->place_y[i] = corners[i].place[1];
    face->vertex[i] = corners[i].vertex;
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
  for (int i = 0; i < 3; ++i) {
    face->x[i] = x[i];
    face->y[i] = y[i];
    face->z[i] = z[i] - outwards * sunk;
  }
  face->area = (x[1] - x[0]) * (y[2] - y[0]) - (y[1] - y[0]) * (x[2] - x[0]);
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

// Twice the area of (from, to, sample). Both faces of an edge get the same number with opposite signs.
double side_of(__global const Face* face, int from, int to, double x, double y) {
  const int lower = face->vertex[from] < face->vertex[to] ? from : to;
  const int upper = lower == from ? to : from;
  const double side = (face->x[upper] - face->x[lower]) * (y - face->y[lower]) -
                      (face->y[upper] - face->y[lower]) * (x - face->x[lower]);
  return lower == from ? side : -side;
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

bool is_deeper(double depth, int sample, double than, int than_sample) {
  return depth > than || (depth == than && sample < than_sample);
}

// What a work group found: the deepest sample, the numbers of covered and of folded ones.
typedef struct {
  double depth_m;
  int sample;
  int covered;
  int folded;
  int padding;
} Found;

void keep_deeper(Found* found, const __local Found* other) {
  if (is_deeper(other->depth_m, other->sample, found->depth_m, found->sample)) {
    found->depth_m = other->depth_m;
    found->sample = other->sample;
  }
  found->covered += other->covered;
  found->folded += other->folded;
}

void reduce(__local Found* shared, int item) {
  for (int apart = GROUP / 2; apart > 0; apart /= 2) {
    barrier(CLK_LOCAL_MEM_FENCE);
    if (item < apart) {
      Found found = shared[item];
      keep_deeper(&found, shared + item + apart);
      shared[item] = found;
    }
  }
  barrier(CLK_LOCAL_MEM_FENCE);
}

// One work group: one tile of the window of one surface of one contact. B is sampled first (first_surface 0), then A in
// all configurations (first_surface 1), whose samples are compared with those of B at once.
__kernel __attribute__((reqd_work_group_size(GROUP, 1, 1)))
void sample_tiles(__global const Task* tasks, __global const Face* faces, __global const short* values_b, int rows_b,
                  int columns_b, double step_b_m, __global const short* values_a, int rows_a, int columns_a,
                  double step_a_m, int first_surface, int most_tiles, __global double* heights_m,
                  __global double* all_rates, int most_samples, __global Found* found) {
  const int item = get_local_id(0);
  const int tile = get_group_id(0);
  const int surface = first_surface + get_group_id(1);
  const int contact = get_group_id(2);
  __global const Task* task = tasks + contact;
  const int across = task->samples / TILE;
  if (surface >= task->used_surfaces || tile >= across * across) return;
  const int body = surface == 0 ? 0 : 1;
  const double outwards = body == 0 ? 1.0 : -1.0;
  Atlas atlas;
  atlas.values = body == 0 ? values_b : values_a;
  atlas.rows = body == 0 ? rows_b : rows_a;
  atlas.columns = body == 0 ? columns_b : columns_a;
  atlas.step_m = body == 0 ? step_b_m : step_a_m;
  const double same_sheet_m = 1e-6 + 2.0 * fabs(atlas.step_m);
  const int tile_row = tile / across * TILE, tile_column = tile % across * TILE;
  const int row = tile_row + item / TILE, column = tile_column + item % TILE;
  const double x = place_m(column, task), y = place_m(row, task);
  const int count = task->count[body];
  __global const Face* own = faces + task->first_face +
                             (surface == 0 ? 0 : task->count[0] + (surface - 1) * task->count[1]);
  const bool wants_rates = task->tau_m > 0.0 && surface == 1;

  // Faces are visited in their order: which of them overlap the tile is determined for GROUP at a time.
  __local uint overlapping[GROUP / 32];
  double most = -INFINITY;  // outwards
  bool is_folded = false;
  double rates[RATES] = {0.0, 0.0, 0.0, 0.0, 0.0};
  for (int base = 0; base < count; base += GROUP) {
    barrier(CLK_LOCAL_MEM_FENCE);
    if (item < GROUP / 32) overlapping[item] = 0;
    barrier(CLK_LOCAL_MEM_FENCE);
    if (base + item < count) {
      __global const Face* face = own + base + item;
      if (face->first_row < tile_row + TILE && face->last_row >= tile_row && face->first_column < tile_column + TILE &&
          face->last_column >= tile_column && face->first_row <= face->last_row) {
        atomic_or(&overlapping[item / 32], 1u << (item % 32));
      }
    }
    barrier(CLK_LOCAL_MEM_FENCE);
    for (int word = 0; word < GROUP / 32; ++word) {
      for (uint left = overlapping[word]; left != 0; left &= left - 1) {
        __global const Face* face = own + base + 32 * word + (31 - clz(left & -left));
        if (row < face->first_row || row > face->last_row || column < face->first_column ||
            column > face->last_column) {
          continue;
        }
        double weights[3];
        bool is_inside = true;
        for (int i = 0; i < 3; ++i) {
          weights[i] = side_of(face, (i + 1) % 3, (i + 2) % 3, x, y) / face->area;
          is_inside = is_inside && !(weights[i] < 0.0);
        }
        if (!is_inside) continue;
        const double height = outwards * height_of(face, &atlas, weights);
        if (most != -INFINITY) {
          if (fabs(height - most) > same_sheet_m) is_folded = true;
          if (height - most <= 0.0) continue;
        }
        most = height;
        if (wants_rates) rates_of(face, &atlas, weights, rates);
      }
    }
  }

  const int sample = row * task->samples + column;
  __global double* heights_of_b_m = heights_m + (size_t)(2 * contact) * most_samples;
  double depth = -INFINITY;
  if (surface == 0) {
    heights_of_b_m[sample] = most;
  } else {
    // −∞ where one of the surfaces is missing; most is −h_A.
    depth = most == -INFINITY ? -INFINITY : heights_of_b_m[sample] + most;
    if (surface == 1) heights_of_b_m[most_samples + sample] = most;
    if (wants_rates) {
      for (int q = 0; q < RATES; ++q) all_rates[((size_t)contact * RATES + q) * most_samples + sample] = rates[q];
    }
  }
  __local Found shared[GROUP];
  shared[item].depth_m = depth;
  shared[item].sample = sample;
  shared[item].covered = depth == -INFINITY ? 0 : 1;
  shared[item].folded = is_folded ? 1 : 0;
  reduce(shared, item);
  if (item == 0) found[((size_t)contact * SURFACES + surface) * most_tiles + tile] = shared[0];
}

bool is_missing(__global const double* heights_of_b_m, int most_samples, int sample) {
  return heights_of_b_m[sample] == -INFINITY || heights_of_b_m[most_samples + sample] == -INFINITY;
}

// One work group: one contact. The deepest sample of each surface, in the fixed order of the tiles.
__kernel __attribute__((reqd_work_group_size(GROUP, 1, 1)))
void find_deepest(__global const Task* tasks, __global const Found* found, int most_tiles,
                  __global const double* heights_m, int most_samples, __global Answer* answers) {
  const int item = get_local_id(0);
  const int contact = get_group_id(0);
  __global const Task* task = tasks + contact;
  __global Answer* answer = answers + contact;
  const int across = task->samples / TILE;
  __local Found shared[GROUP];
  int folded = 0;
  for (int surface = 0; surface < task->used_surfaces; ++surface) {
    Found mine = {-INFINITY, 0, 0, 0, 0};
    for (int tile = item; tile < across * across; tile += GROUP) {
      const Found other = found[((size_t)contact * SURFACES + surface) * most_tiles + tile];
      if (is_deeper(other.depth_m, other.sample, mine.depth_m, mine.sample)) {
        mine.depth_m = other.depth_m;
        mine.sample = other.sample;
      }
      mine.covered += other.covered;
      mine.folded += other.folded;
    }
    shared[item] = mine;
    reduce(shared, item);
    if (item == 0) {
      if (surface < 2) folded += shared[0].folded;
      answer->depth_m[surface] = shared[0].covered > 0 ? shared[0].depth_m : NAN;
      if (surface == 1) {
        const int sample = shared[0].sample, samples = task->samples;
        const int row = sample / samples, column = sample % samples;
        __global const double* heights_of_b_m = heights_m + (size_t)(2 * contact) * most_samples;
        answer->sample = sample;
        answer->covered = shared[0].covered;
        answer->height_m = -heights_of_b_m[most_samples + sample];
        answer->at_border =
            shared[0].covered > 0 &&
            (row == 0 || column == 0 || row == samples - 1 || column == samples - 1 ||
             is_missing(heights_of_b_m, most_samples, sample - 1) ||
             is_missing(heights_of_b_m, most_samples, sample + 1) ||
             is_missing(heights_of_b_m, most_samples, sample - samples) ||
             is_missing(heights_of_b_m, most_samples, sample + samples));
      }
    }
    barrier(CLK_LOCAL_MEM_FENCE);
  }
  if (item == 0) answer->folded = folded;
}

// One work group: the weighted sums of the smooth maximum of one contact, after find_deepest.
__kernel __attribute__((reqd_work_group_size(GROUP, 1, 1)))
void weigh(__global const Task* tasks, __global const double* heights_m, __global const double* all_rates,
           int most_samples, __global Answer* answers) {
  const int item = get_local_id(0);
  const int contact = get_group_id(0);
  __global const Task* task = tasks + contact;
  __global const double* heights_of_b_m = heights_m + (size_t)(2 * contact) * most_samples;
  double sums[SUMS];
  for (int i = 0; i < SUMS; ++i) sums[i] = 0.0;
  const double deepest_m = answers[contact].depth_m[1];
  if (task->tau_m > 0.0) {
    for (int sample = item; sample < task->samples * task->samples; sample += GROUP) {
      if (is_missing(heights_of_b_m, most_samples, sample)) continue;
      const double depth = heights_of_b_m[sample] + heights_of_b_m[most_samples + sample];
      const double log_weight = (depth - deepest_m) / task->tau_m;
      const double weight = exp(log_weight);
      sums[0] += weight;
      sums[1] += weight * log_weight;
      for (int q = 0; q < RATES; ++q) {
        const double rate = all_rates[((size_t)contact * RATES + q) * most_samples + sample];
        sums[2 + q] += weight * rate;
        sums[2 + RATES + q] += weight * log_weight * rate;
      }
    }
  }
  __local double shared[GROUP];
  for (int i = 0; i < SUMS; ++i) {
    shared[item] = sums[i];
    for (int apart = GROUP / 2; apart > 0; apart /= 2) {
      barrier(CLK_LOCAL_MEM_FENCE);
      if (item < apart) shared[item] += shared[item + apart];
    }
    barrier(CLK_LOCAL_MEM_FENCE);
    if (item == 0) answers[contact].sums[i] = shared[0];
    barrier(CLK_LOCAL_MEM_FENCE);
  }
}
