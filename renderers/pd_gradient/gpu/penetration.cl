// The penetration depth of several contacts and its gradient, for all samples and configurations in parallel; continues
// faces.cl.
//
// Results do not depend on the order in which work groups run: maxima are ordered by depth and then by sample, and sums
// have a fixed order within a group and over the groups.
//
// Configurations of the differences need their depth alone. Faces whose upper bound in a tile is below a depth that the
// configuration has elsewhere cannot contain its deepest sample and are left out: the depth is that of all samples.

bool is_deeper(double depth, int sample, double than, int than_sample) {
  return depth > than || (depth == than && sample < than_sample);
}

// A tile of the window of a contact, and this work item's samples in it.
typedef struct {
  int row, column;     // the tile's first sample
  int own_row, own_column;
  double x;
  double spacing_m;
  double middle;
} Tile;

Tile tile_at(__global const Task* task, int index, int item) {
  Tile tile;
  const int across = task->samples / TILE;
  tile.row = index / across * TILE;
  tile.column = index % across * TILE;
  tile.own_row = tile.row + item / TILE;
  tile.own_column = tile.column + item % TILE;
  tile.x = place_m(tile.own_column, task);
  tile.spacing_m = task->spacing_m;
  tile.middle = 0.5 * (task->samples - 1);
  return tile;
}

int sample_of(const Tile* tile, __global const Task* task, int k) {
  return (tile->own_row + k * ROWS) * task->samples + tile->own_column;
}

// An upper bound of the heights of a face in a tile.
double top_of(__global const Face* face, const Tile* tile) {
  const double reach = 0.5 * (TILE - 1) * tile->spacing_m;
  const double x = (tile->column + 0.5 * (TILE - 1) - tile->middle) * tile->spacing_m;
  const double y = (tile->row + 0.5 * (TILE - 1) - tile->middle) * tile->spacing_m;
  return face->top + face->top_x * x + face->top_y * y + (fabs(face->top_x) + fabs(face->top_y)) * reach;
}

// The faces of one surface of a contact.
typedef struct {
  __global const Face* faces;
  int count;
  int most_count;  // of the surfaces that the work group samples side by side
  double outwards;
  Atlas atlas;
} Surface;

// The outermost height of a surface at each of this work item's samples, or -INFINITY, and whether sheets are folded
// there (one bit a sample). Faces that cannot reach `least` beyond `above` are left out.
bool sample_tile(const Surface* surface, const Tile* tile, int item, double above, double least,
                 __local uint* overlapping, double* most, uint* folded) {
  const double same_sheet_m = 1e-6 + 2.0 * fabs(surface->atlas.step_m);
  for (int k = 0; k < PER_ITEM; ++k) most[k] = -INFINITY;
  *folded = 0;
  bool is_over = false;  // the same for all work items
  // Faces are visited in their order: which of them overlap the tile is determined for GROUP at a time.
  for (int base = 0; base < surface->most_count; base += GROUP) {
    barrier(CLK_LOCAL_MEM_FENCE);
    if (item < GROUP / 32) overlapping[item] = 0;
    barrier(CLK_LOCAL_MEM_FENCE);
    if (base + item < surface->count) {
      __global const Face* face = surface->faces + base + item;
      if (face->first_row < tile->row + TILE && face->last_row >= tile->row &&
          face->first_column < tile->column + TILE && face->last_column >= tile->column &&
          face->first_row <= face->last_row && !(above + top_of(face, tile) < least)) {
        atomic_or(&overlapping[item / 32], 1u << (item % 32));
      }
    }
    barrier(CLK_LOCAL_MEM_FENCE);
    for (int word = 0; word < GROUP / 32; ++word) {
      is_over = is_over || overlapping[word] != 0;
      for (uint left = overlapping[word]; left != 0; left &= left - 1) {
        __global const Face* face = surface->faces + base + 32 * word + (31 - clz(left & -left));
        if (tile->own_column < face->first_column || tile->own_column > face->last_column) continue;
        for (int k = 0; k < PER_ITEM; ++k) {
          const int row = tile->own_row + k * ROWS;
          if (row < face->first_row || row > face->last_row) continue;
          const double y = (row - tile->middle) * tile->spacing_m;
          double weights[3];
          if (!weigh_corners(face, tile->x, y, weights)) continue;
          const double height = surface->outwards * height_of(face, &surface->atlas, weights);
          if (most[k] != -INFINITY) {
            if (fabs(height - most[k]) > same_sheet_m) *folded |= 1u << k;
            if (height - most[k] <= 0.0) continue;
          }
          most[k] = height;
        }
      }
    }
  }
  return is_over;
}

// What a tile has of a surface: the deepest sample, and the numbers of covered and of folded ones. Of B, the depth is
// its highest sample.
typedef struct {
  double depth_m;
  int sample;
  int covered;
  int folded;
  int padding;
} Found;

// The same for the items of a group; the first item has the result.
typedef struct {
  double depth_m[GROUP];
  int sample[GROUP];
  int covered[GROUP];
  int folded[GROUP];
} Shared;

void reduce(__local Shared* shared, int item) {
  for (int apart = GROUP / 2; apart > 0; apart /= 2) {
    barrier(CLK_LOCAL_MEM_FENCE);
    if (item < apart) {
      const int other = item + apart;
      if (is_deeper(shared->depth_m[other], shared->sample[other], shared->depth_m[item], shared->sample[item])) {
        shared->depth_m[item] = shared->depth_m[other];
        shared->sample[item] = shared->sample[other];
      }
      shared->covered[item] += shared->covered[other];
      shared->folded[item] += shared->folded[other];
    }
  }
  barrier(CLK_LOCAL_MEM_FENCE);
}

// The greatest of a number of each item.
double greatest_of_group(__local double* shared, int item, double own) {
  barrier(CLK_LOCAL_MEM_FENCE);
  shared[item] = own;
  for (int apart = GROUP / 2; apart > 0; apart /= 2) {
    barrier(CLK_LOCAL_MEM_FENCE);
    if (item < apart) shared[item] = fmax(shared[item], shared[item + apart]);
  }
  barrier(CLK_LOCAL_MEM_FENCE);
  return shared[0];
}

__global Found* found_of(__global Found* found, int contact, int surface, int most_tiles) {
  return found + ((size_t)contact * SURFACES + surface) * most_tiles;
}

// One work group: one tile of the window of one contact. Half of it samples B, the other half A at its pose.
__kernel __attribute__((reqd_work_group_size(2 * GROUP, 1, 1)))
void sample_here(__global const Task* restrict tasks, __global const Face* restrict faces,
                 __global const short* restrict values_b, int rows_b, int columns_b, double step_b_m,
                 __global const short* restrict values_a, int rows_a, int columns_a, double step_a_m, int most_tiles,
                 __global double* restrict heights_m, int most_samples, __global Found* restrict found) {
  const int body = get_local_id(0) / GROUP;
  const int item = get_local_id(0) % GROUP;
  const int index = get_group_id(0);
  const int contact = get_group_id(1);
  __global const Task* task = tasks + contact;
  const int across = task->samples / TILE;
  if (index >= across * across) return;
  const Tile tile = tile_at(task, index, item);
  __local uint overlapping[2][GROUP / 32];
  __local Shared shared[2];
  __local double heights_of_b_m[PER_ITEM][GROUP];

  const int most_count = max(task->count[0], task->count[1]);
  const Surface b = {faces + task->first_face, task->count[0], most_count, 1.0, {values_b, rows_b, columns_b, step_b_m}};
  const Surface a = {b.faces + task->count[0], task->count[1], most_count, -1.0, {values_a, rows_a, columns_a, step_a_m}};
  const Surface own = body == 0 ? b : a;
  double most[PER_ITEM];  // h_B or -h_A
  uint folded;
  sample_tile(&own, &tile, item, 0.0, -INFINITY, overlapping[body], most, &folded);
  __global double* own_heights_m = heights_m + (size_t)(2 * contact + body) * most_samples;
  for (int k = 0; k < PER_ITEM; ++k) {
    own_heights_m[sample_of(&tile, task, k)] = most[k];
    if (body == 0) heights_of_b_m[k][item] = most[k];
  }
  barrier(CLK_LOCAL_MEM_FENCE);
  // Of B the highest sample, of A the deepest.
  double greatest = -INFINITY;
  int its_sample = sample_of(&tile, task, 0);
  int covered = 0;
  for (int k = 0; k < PER_ITEM; ++k) {
    // -INFINITY where one of the surfaces is missing
    const double value = body == 0 || most[k] == -INFINITY ? most[k] : heights_of_b_m[k][item] + most[k];
    if (value > greatest) {
      greatest = value;
      its_sample = sample_of(&tile, task, k);
    }
    covered += value == -INFINITY ? 0 : 1;
  }
  shared[body].depth_m[item] = greatest;
  shared[body].sample[item] = its_sample;
  shared[body].covered[item] = covered;
  shared[body].folded[item] = popcount(folded);
  reduce(&shared[body], item);
  if (item == 0) {
    __global Found* mine = found_of(found, contact, body, most_tiles) + index;
    mine->depth_m = shared[body].depth_m[0];
    mine->sample = shared[body].sample[0];
    mine->covered = shared[body].covered[0];
    mine->folded = shared[body].folded[0];
  }
}

// The deepest sample of the contact at its poses, by one work group.
void find_here(__global const Found* found, int tiles, __local Shared* shared, int item) {
  double depth = -INFINITY;
  int sample = 0, covered = 0, folded = 0;
  for (int tile = item; tile < tiles; tile += GROUP) {
    if (is_deeper(found[tile].depth_m, found[tile].sample, depth, sample)) {
      depth = found[tile].depth_m;
      sample = found[tile].sample;
    }
    covered += found[tile].covered;
    folded += found[tile].folded;
  }
  shared->depth_m[item] = depth;
  shared->sample[item] = sample;
  shared->covered[item] = covered;
  shared->folded[item] = folded;
  reduce(shared, item);
}

// The depth of A, moved, in one tile.
double depth_in_tile(__global const Task* task, int contact, int index, int item, const Surface* a,
                     double above, double least, __global const double* heights_m, int most_samples,
                     __local uint* overlapping, __local double* shared) {
  const Tile tile = tile_at(task, index, item);
  double most[PER_ITEM];
  uint folded;
  if (!sample_tile(a, &tile, item, above, least, overlapping, most, &folded)) return -INFINITY;
  __global const double* heights_of_b_m = heights_m + (size_t)(2 * contact) * most_samples;
  double deepest = -INFINITY;
  for (int k = 0; k < PER_ITEM; ++k) {
    if (most[k] != -INFINITY) deepest = fmax(deepest, heights_of_b_m[sample_of(&tile, task, k)] + most[k]);
  }
  return greatest_of_group(shared, item, deepest);
}

// One work group: one configuration of the differences of one contact. Its depth in the tile that is deepest without
// the difference: no other tile with a lower upper bound needs to be sampled.
__kernel __attribute__((reqd_work_group_size(GROUP, 1, 1)))
void find_bounds(__global const Task* restrict tasks, __global const Face* restrict faces,
                 __global const short* restrict values_a, int rows_a, int columns_a, double step_a_m, int most_tiles,
                 __global const double* restrict heights_m, int most_samples, __global const Found* restrict found,
                 __global double* restrict bounds_m) {
  const int item = get_local_id(0);
  const int surface = 2 + get_group_id(0);
  const int contact = get_group_id(1);
  __global const Task* task = tasks + contact;
  if (surface >= task->used_surfaces) return;
  __local uint overlapping[GROUP / 32];
  __local Shared shared;
  const int across = task->samples / TILE;
  find_here(found + ((size_t)contact * SURFACES + 1) * most_tiles, across * across, &shared, item);
  const int row = shared.sample[0] / task->samples, column = shared.sample[0] % task->samples;
  const Surface a = {faces + task->first_face + task->count[0] + (surface - 1) * task->count[1], task->count[1], task->count[1], -1.0,
                     {values_a, rows_a, columns_a, step_a_m}};
  const double depth = depth_in_tile(task, contact, row / TILE * across + column / TILE, item, &a, 0.0,
                                     -INFINITY, heights_m, most_samples, overlapping, shared.depth_m);
  if (item == 0) bounds_m[contact * SURFACES + surface] = depth;
}

// One work group: one tile of one configuration of the differences.
__kernel __attribute__((reqd_work_group_size(GROUP, 1, 1)))
void sample_moved(__global const Task* restrict tasks, __global const Face* restrict faces,
                  __global const short* restrict values_a, int rows_a, int columns_a, double step_a_m, int most_tiles,
                  __global const double* restrict heights_m, int most_samples, __global const double* restrict bounds_m,
                  __global Found* restrict found) {
  const int item = get_local_id(0);
  const int index = get_group_id(0);
  const int surface = 2 + get_group_id(1);
  const int contact = get_group_id(2);
  __global const Task* task = tasks + contact;
  const int across = task->samples / TILE;
  if (surface >= task->used_surfaces || index >= across * across) return;
  __local uint overlapping[GROUP / 32];
  __local double shared[GROUP];
  const double highest_of_b = found[(size_t)contact * SURFACES * most_tiles + index].depth_m;
  const double bound_m = bounds_m[contact * SURFACES + surface];
  double depth = -INFINITY;
  if (highest_of_b != -INFINITY) {
    const Surface a = {faces + task->first_face + task->count[0] + (surface - 1) * task->count[1], task->count[1],
                       task->count[1], -1.0, {values_a, rows_a, columns_a, step_a_m}};
    depth = depth_in_tile(task, contact, index, item, &a, highest_of_b, bound_m, heights_m, most_samples,
                          overlapping, shared);
  }
  if (item == 0) found_of(found, contact, surface, most_tiles)[index].depth_m = depth;
}

bool is_missing(__global const double* heights_of_b_m, int most_samples, int sample) {
  return heights_of_b_m[sample] == -INFINITY || heights_of_b_m[most_samples + sample] == -INFINITY;
}

// One work group: one surface from A (1) of one contact. Its deepest sample.
__kernel __attribute__((reqd_work_group_size(GROUP, 1, 1)))
void find_deepest(__global const Task* restrict tasks, __global const Found* restrict found, int most_tiles,
                  __global const double* restrict heights_m, int most_samples, __global const double* restrict bounds_m,
                  __global Answer* restrict answers) {
  const int item = get_local_id(0);
  const int surface = 1 + get_group_id(0);
  const int contact = get_group_id(1);
  __global const Task* task = tasks + contact;
  if (surface >= task->used_surfaces) return;
  __global Answer* answer = answers + contact;
  __global const Found* own = found + ((size_t)contact * SURFACES + surface) * most_tiles;
  const int across = task->samples / TILE;
  __local Shared shared;
  if (surface > 1) {
    double depth = bounds_m[contact * SURFACES + surface];
    for (int tile = item; tile < across * across; tile += GROUP) depth = fmax(depth, own[tile].depth_m);
    depth = greatest_of_group(shared.depth_m, item, depth);
    if (item == 0) answer->depth_m[surface] = depth == -INFINITY ? NAN : depth;
    return;
  }
  __global const Found* of_b = found + (size_t)contact * SURFACES * most_tiles;
  find_here(own, across * across, &shared, item);
  const double depth = shared.depth_m[0];
  const int sample = shared.sample[0], covered = shared.covered[0], folded_of_a = shared.folded[0];
  barrier(CLK_LOCAL_MEM_FENCE);
  int folded_of_b = 0;
  for (int tile = item; tile < across * across; tile += GROUP) folded_of_b += of_b[tile].folded;
  shared.folded[item] = folded_of_b;
  reduce(&shared, item);
  if (item != 0) return;
  const int samples = task->samples;
  const int row = sample / samples, column = sample % samples;
  __global const double* heights_of_b_m = heights_m + (size_t)(2 * contact) * most_samples;
  answer->depth_m[1] = covered > 0 ? depth : NAN;
  answer->sample = sample;
  answer->covered = covered;
  answer->folded = folded_of_a + shared.folded[0];
  answer->height_m = -heights_of_b_m[most_samples + sample];
  answer->at_border = covered > 0 && (row == 0 || column == 0 || row == samples - 1 || column == samples - 1 ||
                                      is_missing(heights_of_b_m, most_samples, sample - 1) ||
                                      is_missing(heights_of_b_m, most_samples, sample + 1) ||
                                      is_missing(heights_of_b_m, most_samples, sample - samples) ||
                                      is_missing(heights_of_b_m, most_samples, sample + samples));
}

// One work item: one sample of one contact with the smooth maximum. The rates of the face whose height was found there.
__kernel void rate_heights(__global const Task* restrict tasks, __global const Face* restrict faces,
                           __global const short* restrict values_a, int rows_a, int columns_a, double step_a_m,
                           __global const double* restrict heights_m, int most_samples,
                           __global double* restrict all_rates) {
  const int sample = get_global_id(0);
  const int contact = get_global_id(1);
  __global const Task* task = tasks + contact;
  if (!(task->tau_m > 0.0) || sample >= task->samples * task->samples) return;
  const double most = heights_m[(size_t)(2 * contact + 1) * most_samples + sample];
  if (most == -INFINITY) return;
  const int row = sample / task->samples, column = sample % task->samples;
  const double x = place_m(column, task), y = place_m(row, task);
  const Atlas atlas = {values_a, rows_a, columns_a, step_a_m};
  __global const Face* own = faces + task->first_face + task->count[0];
  for (int f = 0; f < task->count[1]; ++f) {
    __global const Face* face = own + f;
    if (row < face->first_row || row > face->last_row || column < face->first_column || column > face->last_column) {
      continue;
    }
    double weights[3];
    if (!weigh_corners(face, x, y, weights) || -height_of(face, &atlas, weights) != most) continue;
    double rates[RATES];
    rates_of(face, &atlas, weights, rates);
    for (int q = 0; q < RATES; ++q) all_rates[((size_t)contact * RATES + q) * most_samples + sample] = rates[q];
    return;
  }
  // A driver that computes the height otherwise than in sample_here: the answer is not a number, and never an old one.
  for (int q = 0; q < RATES; ++q) all_rates[((size_t)contact * RATES + q) * most_samples + sample] = NAN;
}

// One work group: the weighted sums of the smooth maximum of one contact, after find_deepest.
__kernel __attribute__((reqd_work_group_size(WEIGH_GROUP, 1, 1)))
void weigh(__global const Task* restrict tasks, __global const double* restrict heights_m, __global const double* restrict all_rates,
           int most_samples, __global Answer* restrict answers) {
  const int item = get_local_id(0);
  const int contact = get_group_id(0);
  __global const Task* task = tasks + contact;
  __global const double* heights_of_b_m = heights_m + (size_t)(2 * contact) * most_samples;
  double sums[SUMS];
  for (int i = 0; i < SUMS; ++i) sums[i] = 0.0;
  const double deepest_m = answers[contact].depth_m[1];
  if (task->tau_m > 0.0) {
    for (int sample = item; sample < task->samples * task->samples; sample += WEIGH_GROUP) {
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
  __local double shared[WEIGH_GROUP];
  for (int i = 0; i < SUMS; ++i) {
    shared[item] = sums[i];
    for (int apart = WEIGH_GROUP / 2; apart > 0; apart /= 2) {
      barrier(CLK_LOCAL_MEM_FENCE);
      if (item < apart) shared[item] += shared[item + apart];
    }
    barrier(CLK_LOCAL_MEM_FENCE);
    if (item == 0) answers[contact].sums[i] = shared[0];
    barrier(CLK_LOCAL_MEM_FENCE);
  }
}
