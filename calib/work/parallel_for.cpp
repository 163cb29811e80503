#include "calib/work/parallel_for.h"

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

namespace lumi {
namespace {

/// The indices of one call, handed out one by one to whoever works on it.
class Job {
 public:
    Job(int count, const std::function<void(int)>& body) : count_(count), body_(body) {}

    void work() {
        for (int index = next_++; index < count_; index = next_++) {
            try {
                body_(index);
            } catch (...) {
                const std::scoped_lock lock(failure_mutex_);
                if (!first_failure_) first_failure_ = std::current_exception();
                next_ = count_;
            }
        }
    }

    void rethrow_failure() const {
        if (first_failure_) std::rethrow_exception(first_failure_);
    }

 private:
    const int count_;
    const std::function<void(int)>& body_;
    std::atomic<int> next_{0};
    std::exception_ptr first_failure_;
    std::mutex failure_mutex_;
};

/// Threads that stay, waiting for jobs: to start one for each job of a frame would cost more than
/// many a job. A job's caller works on it, too, and waits only for those who are at work on it, so
/// that jobs within jobs always come to an end, however few threads are free.
class WaitingThreads {
 public:
    void work_with(int most_others, Job& job) {
        Offer offer{&job, most_others};
        {
            const std::scoped_lock lock(mutex_);
            start_threads(most_others);
            offers_.push_back(&offer);
        }
        for (int i = 0; i < most_others; ++i) offered_.notify_one();
        job.work();
        std::unique_lock lock(mutex_);
        std::erase(offers_, &offer);
        left_.wait(lock, [&] { return offer.at_work == 0; });
    }

 private:
    /// Guarded by the mutex.
    struct Offer {
        Job* job;
        int places;  ///< For so many more threads.
        int at_work = 0;
    };

    void start_threads(int wanted) {
        while (threads_ < wanted) {
            try {
                std::thread([this] { help(); }).detach();
            } catch (const std::system_error&) {
                return;  // The system gives no more: those that there are do it.
            }
            ++threads_;
        }
    }

    void help() {
        std::unique_lock lock(mutex_);
        while (true) {
            offered_.wait(lock, [&] { return !offers_.empty(); });
            Offer& offer = *offers_.back();
            if (--offer.places == 0) offers_.pop_back();
            ++offer.at_work;
            lock.unlock();
            offer.job->work();
            lock.lock();
            if (--offer.at_work == 0) left_.notify_all();
        }
    }

    std::mutex mutex_;
    std::condition_variable offered_;
    std::condition_variable left_;
    std::vector<Offer*> offers_;
    int threads_ = 0;
};

/// Never destroyed: its threads wait until the process ends.
WaitingThreads& waiting_threads() {
    static auto* const all = new WaitingThreads;
    return *all;
}

}  // namespace

int resolve_threads(int threads) {
    // Asked once: the C library reads a file each time, and a frame would ask a dozen times.
    static const int cores = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
    return threads > 0 ? threads : cores;
}

void parallel_for(int count, int threads, const std::function<void(int)>& body) {
    Job job(count, body);
    const int most_others = std::min(resolve_threads(threads), count) - 1;
    if (most_others > 0) {
        waiting_threads().work_with(most_others, job);
    } else {
        job.work();
    }
    job.rethrow_failure();
}

void parallel_for_runs(std::size_t count, std::size_t run, int threads,
                       const std::function<void(std::size_t, std::size_t)>& body) {
    const std::size_t runs = (count + run - 1) / run;
    parallel_for(static_cast<int>(runs), threads, [&](int i) {
        const std::size_t first = static_cast<std::size_t>(i) * run;
        body(first, std::min(first + run, count));
    });
}

}  // namespace lumi
