#include "engine/render/render.hpp"

#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/partitioner.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <mutex>

#include "engine/render/error_driven_pixel.hpp"

namespace lute {
namespace {

using RenderBlock = std::function<void(const PixelArea& block, PixelSource& source)>;

// The blocks of one pass over an area, from whichever thread.
class BlockRun {
 public:
  BlockRun(const PixelArea& area, int block_size, RenderBlock render_block, const RenderProgress& progress)
      : grid_(area, block_size), render_block_(std::move(render_block)), progress_(progress) {}

  int blocks() const { return grid_.count(); }
  bool complete() const { return finished_ == blocks(); }

  void block(int index, PixelSource& source) {
    if (progress_.cancel != nullptr && progress_.cancel->load(std::memory_order_relaxed)) return;
    const PixelArea area = grid_.block(index);
    render_block_(area, source);
    const std::lock_guard lock(mutex_);
    ++finished_;
    done_ += area.pixels();
    if (progress_.report) progress_.report(done_, 0);
  }

 private:
  BlockGrid grid_;
  RenderBlock render_block_;
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

// Renders from several passes, each over all blocks before the next one begins.
class Passes {
 public:
  Passes(const RenderSettings& settings, const MakePixelSource& make_source, const RenderProgress& progress, int count)
      : settings_(settings), make_source_(make_source), progress_(progress), count_(count) {}

  void run(const PixelArea& area, RenderBlock render_block) {
    const long before = passed_++, total = settings_.area.pixels();
    // There are more corners than pixels.
    RenderProgress progress{nullptr, progress_.cancel};
    if (progress_.report) {
      progress.report = [&](long done, long) {
        progress_.report((before * total + std::min(done, total)) / count_, total);
      };
    }
    BlockRun run(area, settings_.block_size, std::move(render_block), progress);
    if (settings_.threads > 1 && run.blocks() > 1) {
      run_parallel(run, settings_.threads, make_source_, result_.counters);
    } else {
      const std::unique_ptr<PixelSource> source = make_source_();
      for (int index = 0; index < run.blocks(); ++index) run.block(index, *source);
      result_.counters.add(source->counters());
    }
    result_.complete = result_.complete && run.complete();
  }

  RenderResult& result() { return result_; }

 private:
  const RenderSettings& settings_;
  const MakePixelSource& make_source_;
  const RenderProgress& progress_;
  int count_;
  long passed_ = 0;
  RenderResult result_;
};

// The area and `pixels` more on each side, as far as the picture goes.
PixelArea grown(const PixelArea& area, int pixels, const Film& film) {
  return {std::max(area.first_column - pixels, 0), std::max(area.first_row - pixels, 0),
          std::min(area.last_column + pixels, film.width() - 1), std::min(area.last_row + pixels, film.height() - 1)};
}

RenderResult render_error_driven(const RenderSettings& settings, const DisplayMetric& metric,
                                 const MakePixelSource& make_source, Film& film, const RenderProgress& progress) {
  // A look may find patterns that the next one follows; each asks for the pixels around.
  constexpr int kMoreLooks = 5, kReach = FindingMap::kReach;
  const PixelArea whole = grown(settings.area, kMoreLooks * kReach, film);
  ErrorMap errors(settings.area);
  CornerSamples corners(whole, metric);
  const double bound = settings.antialiasing.error_bound;
  const ErrorDrivenTarget target{settings.area, film, errors};
  Passes passes(settings, make_source, progress, 3 + kMoreLooks);
  passes.run(corners.area_of_black(),
             [&](const PixelArea& block, PixelSource& source) { corners.trace_black(block, source); });
  passes.run(corners.area(),
             [&](const PixelArea& block, PixelSource& source) { corners.fill_white(block, bound, source); });
  FindingMap findings(whole);
  passes.run(whole, [&](const PixelArea& block, PixelSource& source) {
    render_error_driven_block(block, bound, corners, metric, source, target, findings);
  });
  for (int look = kMoreLooks - 1; look >= 0; --look) {
    const FindingMap before = findings;
    passes.run(grown(settings.area, look * kReach, film), [&](const PixelArea& block, PixelSource& source) {
      look_again_at_block(block, bound, corners, metric, source, target, before, findings);
    });
  }
  passes.result().estimated_error = errors.rmse();
  return passes.result();
}

}  // namespace

RenderResult render(const RenderSettings& settings, const MakePixelSource& make_source, Film& film,
                    const RenderProgress& progress) {
  // Its tables are worth their making only where errors are estimated.
  std::optional<DisplayMetric> display;
  if (settings.estimates()) display.emplace(settings.gamma_mode, settings.assumed_gamma, settings.alpha);
  if (settings.antialiasing.error_driven()) return render_error_driven(settings, *display, make_source, film, progress);
  const ColorMetric metric(settings.antialiasing, settings.gamma_mode, settings.assumed_gamma);
  std::optional<ErrorMap> errors;
  std::optional<ErrorRecord> record;
  if (settings.estimate_error) record.emplace(ErrorRecord{*display, errors.emplace(settings.area)});
  Passes passes(settings, make_source, progress, 1);
  passes.run(settings.area, [&](const PixelArea& block, PixelSource& source) {
    render_block(block, settings.antialiasing, metric, source, film, record ? &*record : nullptr);
  });
  if (errors) {
    errors->estimate_centres(film, *display);
    passes.result().estimated_error = errors->rmse();
  }
  return passes.result();
}

}  // namespace lute
