#include "engine/render/render.hpp"

#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/partitioner.h>
#include <tbb/task_arena.h>

#include <mutex>

namespace lute {
namespace {

// The blocks of one render, from whichever thread.
class BlockRun {
 public:
  BlockRun(const RenderSettings& settings, Film& film, const RenderProgress& progress)
      : settings_(settings),
        metric_(settings.antialiasing, settings.gamma_mode, settings.assumed_gamma),
        grid_(settings.area, settings.block_size),
        film_(film),
        progress_(progress) {}

  int blocks() const { return grid_.count(); }
  bool cancelled() const { return progress_.cancel != nullptr && progress_.cancel->load(std::memory_order_relaxed); }
  bool complete() const { return finished_ == blocks(); }

  void block(int index, PixelSource& source) {
    if (cancelled()) return;
    const PixelArea area = grid_.block(index);
    render_block(area, settings_.antialiasing, metric_, source, film_);
    const std::lock_guard lock(mutex_);
    ++finished_;
    done_ += area.pixels();
    if (progress_.report) progress_.report(done_, settings_.area.pixels());
  }

 private:
  const RenderSettings& settings_;
  ColorMetric metric_;
  BlockGrid grid_;
  Film& film_;
  const RenderProgress& progress_;
  std::mutex mutex_;
  int finished_ = 0;
  long done_ = 0;
};

void run_parallel(BlockRun& run, int threads, const MakePixelSource& make_source, Counters& counters) {
  // More threads than processors are allowed: the arena alone would not start them.
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads));
  tbb::enumerable_thread_specific<std::unique_ptr<PixelSource>> sources([&] { return make_source(); });
  tbb::task_arena arena(threads);
  arena.execute([&] {
    tbb::parallel_for(
        tbb::blocked_range<int>(0, run.blocks(), 1),
        [&](const tbb::blocked_range<int>& range) {
          for (int index = range.begin(); index != range.end(); ++index) run.block(index, *sources.local());
        },
        tbb::simple_partitioner());
  });
  for (const auto& source : sources) counters.add(source->counters());
}

}  // namespace

RenderResult render(const RenderSettings& settings, const MakePixelSource& make_source, Film& film,
                    const RenderProgress& progress) {
  BlockRun run(settings, film, progress);
  RenderResult result;
  if (settings.threads > 1 && run.blocks() > 1) {
    run_parallel(run, settings.threads, make_source, result.counters);
  } else {
    const std::unique_ptr<PixelSource> source = make_source();
    for (int index = 0; index < run.blocks(); ++index) run.block(index, *source);
    result.counters = source->counters();
  }
  result.complete = run.complete();
  return result;
}

}  // namespace lute
