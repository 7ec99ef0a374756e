// SPDX-License-Identifier: BSD-3-Clause
// libstltsa for C++20: stltsa.h with move-only handles, exceptions, std::string and std::span.
// stltsa.h documents each function and its options.
//
//     const stltsa::Clip clip = stltsa::Clip::open("walk.bvh");
//     for (const stltsa::Interval& unit : stltsa::decompose(clip).units())
//         std::cout << stltsa::unit_name(unit.kind) << ' ' << unit.begin_s << " s\n";
//
// Failures are thrown as stltsa::Error. Keys and kinds are the constants of stltsa.h; get() of each
// object returns its C handle. An Options object without settings means the defaults.
#ifndef STLTSA_HPP
#define STLTSA_HPP

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "stltsa.h"

namespace stltsa {
// The library has an inner namespace stltsa. The version keeps these names apart from those in a
// static link; users leave it out.
inline namespace v0 {

class Error : public std::runtime_error {
  public:
    Error(stltsa_status status, const std::string& text)
        : std::runtime_error(text), status_(status) {}
    stltsa_status status() const noexcept { return status_; }
    /// "STLTSA_E_SHAPE" and so on.
    const char* name() const noexcept { return stltsa_status_name(status_); }

  private:
    stltsa_status status_;
};

using Interval = stltsa_interval;
using Segment = stltsa_segment;
using Part = stltsa_part;
using Travel = stltsa_travel;
using Statistics = stltsa_statistics;
using Summary = stltsa_summary;
using Seam = stltsa_seam;
using Event = stltsa_event;
using Difference = stltsa_estimate;
using ComparedCycles = stltsa_compared_cycles;
using ComparedPart = stltsa_compared_part;
using LiveFrame = stltsa_live_frame;
using Piece = stltsa_piece; ///< see Clip::piece()
using OptionInfo = stltsa_option_info;
using InfoKey = stltsa_info_key;

/// Numbers in row order, as the library returns them.
struct Matrix {
    std::int64_t rows = 0;
    std::int64_t cols = 0;
    std::vector<double> values; ///< rows * cols

    Matrix() = default;
    Matrix(std::int64_t row_count, std::int64_t col_count)
        : rows(row_count), cols(col_count),
          values(static_cast<std::size_t>(row_count) * static_cast<std::size_t>(col_count)) {}

    double& operator()(std::int64_t r, std::int64_t c) {
        return values[static_cast<std::size_t>(r * cols + c)];
    }
    double operator()(std::int64_t r, std::int64_t c) const {
        return values[static_cast<std::size_t>(r * cols + c)];
    }
    std::span<const double> row(std::int64_t r) const {
        return std::span(values).subspan(static_cast<std::size_t>(r * cols),
                                         static_cast<std::size_t>(cols));
    }
};

/// The caller's numbers, read in place. For strides, construct it from a stltsa_in.
class MatrixView {
  public:
    MatrixView(const stltsa_in& in) : in_(in) {}
    MatrixView(const Matrix& matrix)
        : in_{matrix.values.data(), matrix.rows, matrix.cols, 0, 0, STLTSA_F64, 0} {}
    /// Packed rows of the given number of columns. Throws Error if the values are not whole rows.
    MatrixView(std::span<const double> values, std::int64_t cols)
        : in_{values.data(), rows_of(values.size(), cols), cols, 0, 0, STLTSA_F64, 0} {}
    MatrixView(std::span<const float> values, std::int64_t cols)
        : in_{values.data(), rows_of(values.size(), cols), cols, 0, 0, STLTSA_F32, 0} {}

    const stltsa_in* get() const noexcept { return &in_; }
    std::int64_t rows() const noexcept { return in_.rows; }

  private:
    static std::int64_t rows_of(std::size_t count, std::int64_t cols) {
        if (cols <= 0 || count % static_cast<std::size_t>(cols) != 0)
            throw Error(STLTSA_E_SHAPE, std::to_string(count) + " values are not rows of " +
                                            std::to_string(cols) + " columns");
        return static_cast<std::int64_t>(count) / cols;
    }

    stltsa_in in_;
};

namespace detail {

/// The exception of a progress callback on this thread, kept until its call returns.
inline std::exception_ptr& thrown() noexcept {
    thread_local std::exception_ptr thrown_by_callback;
    return thrown_by_callback;
}

inline void check(stltsa_status status) {
    if (status == STLTSA_OK)
        return;
    if (const std::exception_ptr by_callback = std::exchange(thrown(), nullptr))
        std::rethrow_exception(by_callback);
    throw Error(status, stltsa_last_error());
}

template <auto free_handle>
struct Free {
    template <class T>
    void operator()(T* handle) const noexcept {
        free_handle(handle);
    }
};
template <class T, auto free_handle>
using Handle = std::unique_ptr<T, Free<free_handle>>;

/// The object of class T that make(..., Handle**) makes.
template <class T, class Make, class... Arguments>
T made(Make make, Arguments... arguments) {
    typename T::Pointer handle = nullptr;
    check(make(arguments..., &handle));
    return T(handle);
}

template <class Value, class Get, class... Arguments>
Value got(Get get, Arguments... arguments) {
    Value value{};
    check(get(arguments..., &value));
    return value;
}

template <class Write, class T>
std::string json(Write write, const T* handle) {
    const Handle<char, stltsa_free> text(got<char*>(write, handle));
    return text.get();
}

inline stltsa_out out(Matrix& matrix) noexcept {
    return {matrix.values.data(), matrix.rows, matrix.cols, 0, 0, STLTSA_F64, 0};
}
inline stltsa_out out(std::vector<double>& column) noexcept {
    return {column.data(), static_cast<std::int64_t>(column.size()), 1, 0, 0, STLTSA_F64, 0};
}

inline stltsa_out out(std::vector<std::int64_t>& list) noexcept {
    return {list.data(), static_cast<std::int64_t>(list.size()), 1, 0, 0, STLTSA_I64, 0};
}

/// A list as the library reads it; an empty one is none.
class List {
  public:
    explicit List(std::span<const std::int64_t> list)
        : in_{list.data(), static_cast<std::int64_t>(list.size()), 1, 0, 0, STLTSA_I64, 0} {}
    const stltsa_in* get() const noexcept { return in_.rows == 0 ? nullptr : &in_; }

  private:
    stltsa_in in_;
};

template <class Fill, class T, class... Arguments>
Matrix matrix(Fill fill, const T* handle, std::int64_t rows, std::int64_t cols,
              Arguments... arguments) {
    Matrix result(rows, cols);
    const stltsa_out to = out(result);
    check(fill(handle, arguments..., &to));
    return result;
}

/// The results of item(index) for 0 to count - 1.
template <class Item>
auto list(std::int64_t count, Item item) {
    std::vector<decltype(item(count))> items;
    for (std::int64_t i = 0; i < count; ++i)
        items.push_back(item(i));
    return items;
}

template <class Count, class Text, class T>
std::vector<std::string> texts(Count count, Text text, const T* handle) {
    return list(count(handle), [&](std::int64_t i) { return std::string(text(handle, i)); });
}

} // namespace detail

inline std::string version() {
    return stltsa_version();
}
inline std::int32_t version_number() noexcept {
    return stltsa_version_number();
}
/// Whether this build has the part STLTSA_HAS_*.
inline bool has(std::int32_t part) noexcept {
    return stltsa_has(part) != 0;
}
inline std::string status_name(stltsa_status status) {
    return stltsa_status_name(status);
}
inline std::string segment_name(std::int32_t kind) {
    return stltsa_segment_name(kind);
}
inline std::string unit_name(std::int32_t kind) {
    return stltsa_unit_name(kind);
}

/// One row for each option.
inline std::vector<OptionInfo> option_table() {
    return detail::list(stltsa_option_count(), [](std::int64_t index) {
        OptionInfo info{};
        info.size = sizeof info;
        detail::check(stltsa_option_describe(index, &info));
        return info;
    });
}

/// One row for each key of Info.
inline std::vector<InfoKey> info_table() {
    return detail::list(stltsa_info_key_count(), [](std::int64_t index) {
        InfoKey key{};
        key.size = sizeof key;
        detail::check(stltsa_info_describe(index, &key));
        return key;
    });
}

/// Facts by key, as info() of an object gives them; they are valid as long as the object.
class Info {
  public:
    explicit Info(const stltsa_info* of) : info_(of) {}

    std::int64_t count(std::int32_t key) const noexcept { return stltsa_info_count(info_, key); }
    std::int64_t integer(std::int32_t key, std::int64_t index = 0) const {
        return detail::got<std::int64_t>(stltsa_info_int, info_, key, index);
    }
    double real(std::int32_t key, std::int64_t index = 0) const {
        return detail::got<double>(stltsa_info_real, info_, key, index);
    }
    std::string text(std::int32_t key, std::int64_t index = 0) const {
        return detail::got<const char*>(stltsa_info_text, info_, key, index);
    }
    std::vector<std::int64_t> integers(std::int32_t key) const {
        return detail::list(count(key), [&](std::int64_t index) { return integer(key, index); });
    }
    std::vector<double> reals(std::int32_t key) const {
        return detail::list(count(key), [&](std::int64_t index) { return real(key, index); });
    }
    std::vector<std::string> texts(std::int32_t key) const {
        return detail::list(count(key), [&](std::int64_t index) { return text(key, index); });
    }

  private:
    const stltsa_info* info_;
};

class Options {
  public:
    using Pointer = stltsa_options*;
    /// Receives the stage and its completed part, 0 to 1; returning true cancels the call. Its
    /// exceptions propagate from the call.
    using Progress = std::function<bool(std::int32_t stage, double fraction)>;

    /// A whole number, a switch, or one of the constants.
    template <class Value>
    requires std::is_integral_v<Value> || std::is_enum_v<Value> Options& set(std::int32_t key,
                                                                             Value value) {
        detail::check(stltsa_options_set_int(made(), key, static_cast<std::int64_t>(value)));
        return *this;
    }
    template <std::floating_point Value>
    Options& set(std::int32_t key, Value value) {
        detail::check(stltsa_options_set_real(made(), key, static_cast<double>(value)));
        return *this;
    }
    Options& set(std::int32_t key, const std::string& value) {
        detail::check(stltsa_options_set_text(made(), key, value.c_str()));
        return *this;
    }
    Options& set_progress(Progress progress) {
        auto kept = std::make_unique<Progress>(std::move(progress));
        detail::check(stltsa_options_set_progress(made(), *kept ? call : nullptr, kept.get()));
        progress_ = std::move(kept);
        return *this;
    }

    /// Restores the default or the automatic choice.
    Options& unset(std::int32_t key) {
        detail::check(stltsa_options_unset(made(), key));
        return *this;
    }
    bool is_set(std::int32_t key) const noexcept { return stltsa_options_is_set(get(), key) != 0; }

    std::int64_t integer(std::int32_t key) const {
        return detail::got<std::int64_t>(stltsa_options_get_int, get(), key);
    }
    double real(std::int32_t key) const {
        return detail::got<double>(stltsa_options_get_real, get(), key);
    }
    std::string text(std::int32_t key) const {
        return detail::got<const char*>(stltsa_options_get_text, get(), key);
    }

    const stltsa_options* get() const noexcept { return handle_.get(); }

  private:
    stltsa_options* made() {
        if (!handle_)
            handle_.reset(detail::got<stltsa_options*>(stltsa_options_new));
        return handle_.get();
    }
    static std::int32_t call(void* user, std::int32_t stage, double fraction) {
        try {
            return (*static_cast<Progress*>(user))(stage, fraction) ? 1 : 0;
        } catch (...) {
            detail::thrown() = std::current_exception();
            return 1;
        }
    }

    std::unique_ptr<Progress> progress_; // outlives the handle that points to it
    detail::Handle<stltsa_options, stltsa_options_free> handle_;
};

struct Joint {
    std::string name;
    std::int64_t parent = -1; ///< -1: the root
    std::array<double, 3> offset{};
    std::optional<std::string> channels; ///< see stltsa_joint
    bool is_end_site = false;
};

/// See stltsa_file_event.
struct FileEvent {
    std::string label, context;
    double frame = 0;
    double seconds = 0; ///< 0 if the rate is unknown
};

/// See stltsa_points. Views that are empty are not used.
struct Points {
    MatrixView positions;
    std::int32_t space = 3;
    std::vector<std::string> names;
    std::optional<MatrixView> confidence, times;
    double fps = 0;
};

class Clip {
  public:
    using Pointer = stltsa_clip*;

    explicit Clip(stltsa_clip* owned) : handle_(owned, Free{owned}) {}

    static Clip open(const std::string& path, const Options& options = {}) {
        return detail::made<Clip>(stltsa_clip_open, path.c_str(), options.get());
    }
    /// If `format` is 0, the content decides. `name`: see stltsa_clip_parse; empty: none.
    static Clip parse(std::span<const std::byte> bytes, std::int32_t format = 0,
                      const Options& options = {}, const std::string& name = {}) {
        return detail::made<Clip>(stltsa_clip_parse, bytes.data(), bytes.size(), format,
                                  name.empty() ? nullptr : name.c_str(), options.get());
    }
    static Clip from_matrix(const MatrixView& frames, double fps) {
        return detail::made<Clip>(stltsa_clip_from_matrix, frames.get(), fps);
    }
    /// See stltsa_clip_from_points.
    static Clip from_points(const Points& points, const Options& options = {}) {
        stltsa_points given{};
        given.size = sizeof given;
        given.space = points.space;
        given.positions = *points.positions.get();
        std::vector<const char*> names;
        for (const std::string& name : points.names)
            names.push_back(name.c_str());
        given.names = names.empty() ? nullptr : names.data();
        if (points.confidence)
            given.confidence = *points.confidence->get();
        if (points.times)
            given.times = *points.times->get();
        given.fps = points.fps;
        return detail::made<Clip>(stltsa_clip_from_points, &given, options.get());
    }
    /// See stltsa_clip_from_skeleton; `form` is one of STLTSA_ROTATIONS_*.
    static Clip from_skeleton(const std::vector<Joint>& joints, std::int32_t form,
                              const MatrixView& rotations,
                              const std::optional<MatrixView>& root_positions, double fps) {
        std::vector<stltsa_joint> list;
        for (const Joint& joint : joints) {
            stltsa_joint each{};
            each.size = sizeof each;
            each.name = joint.name.c_str();
            each.parent = joint.parent;
            std::copy(joint.offset.begin(), joint.offset.end(), each.offset);
            each.channels = joint.channels ? joint.channels->c_str() : nullptr;
            each.is_end_site = joint.is_end_site ? 1 : 0;
            list.push_back(each);
        }
        return detail::made<Clip>(stltsa_clip_from_skeleton, list.data(),
                                  static_cast<std::int64_t>(list.size()), form, rotations.get(),
                                  root_positions ? root_positions->get() : nullptr, fps);
    }

    /// See stltsa_clip_set_path. Throws Error if the clip belongs to a result.
    void set_path(const std::string& path) {
        detail::check(stltsa_clip_set_path(handle_.get_deleter().owned, path.c_str()));
    }
    /// See stltsa_clip_stretch.
    Clip stretch(const std::string& what, const Options& options = {}) const {
        return detail::made<Clip>(stltsa_clip_stretch, get(), what.c_str(), options.get());
    }
    /// See stltsa_clip_mirror.
    Clip mirrored(const Options& options = {}) const {
        return detail::made<Clip>(stltsa_clip_mirror, get(), options.get());
    }
    /// See stltsa_clip_find.
    std::vector<stltsa_interval> find(const std::string& what, const Options& options = {}) const {
        std::int64_t count = 0;
        std::vector<stltsa_interval> found(1);
        for (;;) {
            const auto room = static_cast<std::int64_t>(found.size());
            detail::check(
                stltsa_clip_find(get(), what.c_str(), options.get(), room, found.data(), &count));
            found.resize(static_cast<std::size_t>(count));
            if (count <= room)
                return found;
        }
    }

    std::int64_t frames() const noexcept { return stltsa_clip_frames(get()); }
    double fps() const noexcept { return stltsa_clip_fps(get()); }
    std::int32_t format() const noexcept { return stltsa_clip_format(get()); }
    std::int64_t channels() const noexcept { return stltsa_clip_channels(get()); }
    std::int64_t joint_count() const noexcept { return stltsa_clip_joints(get()); }
    Joint joint(std::int64_t index) const {
        stltsa_joint found{};
        found.size = sizeof found;
        detail::check(stltsa_clip_joint(get(), index, &found));
        Joint joint{found.name, found.parent, {}, {}, found.is_end_site != 0};
        std::copy(found.offset, found.offset + 3, joint.offset.begin());
        if (found.channels != nullptr)
            joint.channels = found.channels;
        return joint;
    }
    std::vector<Joint> joints() const {
        return detail::list(joint_count(), [this](std::int64_t index) { return joint(index); });
    }
    /// Events that the file states, in order of time.
    std::vector<FileEvent> events() const {
        return detail::list(stltsa_clip_event_count(get()), [this](std::int64_t index) {
            stltsa_file_event found{};
            found.size = sizeof found;
            detail::check(stltsa_clip_event(get(), index, &found));
            return FileEvent{found.label, found.context, found.frame, found.seconds};
        });
    }
    Matrix positions() const {
        return detail::matrix(stltsa_clip_positions, get(), frames(), 3 * joint_count());
    }
    Matrix rotations() const {
        return detail::matrix(stltsa_clip_rotations, get(), frames(), 4 * joint_count());
    }
    std::int64_t feature_count(const Options& options = {}) const {
        return detail::got<std::int64_t>(stltsa_clip_feature_count, get(), options.get());
    }
    Matrix features(const Options& options = {}) const {
        return detail::matrix(stltsa_clip_features, get(), frames(), feature_count(options),
                              options.get());
    }
    Info info() const noexcept { return Info(stltsa_clip_info(get())); }
    std::string json() const { return detail::json(stltsa_clip_json, get()); }
    void save(const std::string& path, const Options& options = {}) const {
        detail::check(stltsa_clip_save_with(get(), path.c_str(), options.get()));
    }

    /// Frames [begin, end) of this clip, for synthesize(); the clip must outlive that call.
    Piece piece(std::int64_t begin, std::int64_t end, std::int64_t repeat = 1) const noexcept {
        return {get(), begin, end, repeat, 0};
    }

    const stltsa_clip* get() const noexcept { return handle_.get(); }

  private:
    friend class Synthesis;
    struct Free {
        stltsa_clip* owned = nullptr; ///< nullptr: another object owns the clip
        void operator()(const stltsa_clip*) const noexcept { stltsa_clip_free(owned); }
    };
    explicit Clip(const stltsa_clip* borrowed) : handle_(borrowed, Free{}) {}

    std::unique_ptr<const stltsa_clip, Free> handle_;
};

/// Results of Model::map() and Model::unmap() for each row.
struct Mapped {
    Matrix values; ///< coordinates, or frames
    std::vector<double> distance;
    std::vector<std::int64_t> nearest;
};

struct Poses {
    Clip clip;
    std::vector<double> distance;
    std::vector<std::int64_t> nearest;
};

class Model {
  public:
    using Pointer = stltsa_model*;
    using Hints = std::span<const std::int64_t>; ///< empty: none

    explicit Model(stltsa_model* owned) : handle_(owned) {}

    static Model load(const std::string& path) {
        return detail::made<Model>(stltsa_model_load, path.c_str());
    }
    static Model parse(std::span<const std::byte> bytes) {
        return detail::made<Model>(stltsa_model_parse, bytes.data(), bytes.size());
    }
    void save(const std::string& path) const {
        detail::check(stltsa_model_save(get(), path.c_str()));
    }
    std::vector<std::byte> serialize() const {
        unsigned char* bytes = nullptr;
        std::size_t size = 0;
        detail::check(stltsa_model_serialize(get(), &bytes, &size));
        const detail::Handle<unsigned char, stltsa_free> owner(bytes);
        const auto all = std::as_bytes(std::span(bytes, size));
        return {all.begin(), all.end()};
    }

    Matrix coords() const {
        return detail::matrix(stltsa_model_coords, get(), info().integer(STLTSA_INFO_ROWS),
                              info().integer(STLTSA_INFO_DIMENSION));
    }
    Matrix eigenvalues() const {
        return detail::matrix(stltsa_model_eigenvalues, get(),
                              info().integer(STLTSA_INFO_COMPONENTS),
                              info().integer(STLTSA_INFO_DIMENSION) + 2);
    }
    /// The component of each row.
    std::vector<std::int64_t> components() const {
        std::vector<std::int64_t> labels(
            static_cast<std::size_t>(info().integer(STLTSA_INFO_ROWS)));
        const stltsa_out out = detail::out(labels);
        detail::check(stltsa_model_components(get(), &out));
        return labels;
    }
    std::vector<std::string> warnings() const {
        return detail::texts(stltsa_model_warning_count, stltsa_model_warning, get());
    }
    Info info() const noexcept { return Info(stltsa_model_info(get())); }
    std::string json() const { return detail::json(stltsa_model_json, get()); }

    Mapped map(const MatrixView& frames, const Options& options = {}, Hints hints = {}) const {
        return mapped(stltsa_map, info().integer(STLTSA_INFO_DIMENSION), frames, options, hints);
    }
    Mapped map(const Clip& clip, const Options& options = {}) const {
        Mapped result = room(clip.frames(), info().integer(STLTSA_INFO_DIMENSION));
        const stltsa_out values = detail::out(result.values);
        const stltsa_out distance = detail::out(result.distance);
        const stltsa_out nearest = detail::out(result.nearest);
        detail::check(
            stltsa_map_clip(get(), clip.get(), options.get(), &values, &distance, &nearest));
        return result;
    }
    Mapped unmap(const MatrixView& coords, const Options& options = {}, Hints hints = {}) const {
        return mapped(stltsa_unmap, info().integer(STLTSA_INFO_FEATURE_COUNT), coords, options,
                      hints);
    }
    Poses unmap_clip(const MatrixView& coords, const Options& options = {},
                     Hints hints = {}) const {
        Mapped result = room(coords.rows(), 0);
        const stltsa_out distance = detail::out(result.distance);
        const stltsa_out nearest = detail::out(result.nearest);
        Clip clip =
            detail::made<Clip>(stltsa_unmap_clip, get(), coords.get(), detail::List(hints).get(),
                               options.get(), &distance, &nearest);
        return {std::move(clip), std::move(result.distance), std::move(result.nearest)};
    }
    stltsa_model* get() noexcept { return handle_.get(); }
    /// For Live.
    bool has_cycle() const noexcept { return stltsa_model_has_cycle(get()) != 0; }
    const stltsa_model* get() const noexcept { return handle_.get(); }

  private:
    static Mapped room(std::int64_t rows, std::int64_t cols) {
        const auto count = static_cast<std::size_t>(rows);
        return {Matrix(rows, cols), std::vector<double>(count), std::vector<std::int64_t>(count)};
    }
    template <class Map>
    Mapped mapped(Map call, std::int64_t cols, const MatrixView& rows, const Options& options,
                  Hints hints) const {
        Mapped result = room(rows.rows(), cols);
        const stltsa_out values = detail::out(result.values);
        const stltsa_out distance = detail::out(result.distance);
        const stltsa_out nearest = detail::out(result.nearest);
        detail::check(call(get(), rows.get(), detail::List(hints).get(), options.get(), &values,
                           &distance, &nearest));
        return result;
    }

    detail::Handle<stltsa_model, stltsa_model_free> handle_;
};

/// Frames of each clip, if several follow each other in a matrix; empty: one clip.
using Lengths = std::span<const std::int64_t>;

namespace detail {

/// Calls make(in, lengths, options, ...), a C function that takes several clips.
template <class T, class Make>
T made_of_rows(Make make, const MatrixView& rows, const Options& options, Lengths lengths) {
    return made<T>(make, rows.get(), List(lengths).get(), options.get());
}

template <class T, class Make>
T made_of_clips(Make make, std::span<const Clip> clips, const Options& options) {
    std::vector<const stltsa_clip*> handles;
    for (const Clip& clip : clips)
        handles.push_back(clip.get());
    return made<T>(make, handles.data(), static_cast<std::int64_t>(handles.size()), options.get());
}

} // namespace detail

inline Model fit(const MatrixView& frames, const Options& options = {}, Lengths lengths = {}) {
    return detail::made_of_rows<Model>(stltsa_fit, frames, options, lengths);
}
inline Model fit(const Clip& clip, const Options& options = {}) {
    return detail::made<Model>(stltsa_fit_clip, clip.get(), options.get());
}
/// Several clips, each prepared separately.
inline Model fit(std::span<const Clip> clips, const Options& options = {}) {
    return detail::made_of_clips<Model>(stltsa_fit_clips, clips, options);
}

class Dimension {
  public:
    using Pointer = stltsa_dimension*;
    struct Estimate {
        std::int64_t dimension = 0; ///< 0: cannot tell
        std::string reason;         ///< why not
    };

    explicit Dimension(stltsa_dimension* owned) : handle_(owned) {}

    Estimate eigengap() const { return estimate(stltsa_dimension_eigengap); }
    Estimate local_pca() const { return estimate(stltsa_dimension_local_pca); }
    std::vector<double> eigenvalues() const {
        return values(STLTSA_INFO_EIGENVALUE, stltsa_dimension_eigenvalues);
    }
    std::vector<double> local_variances() const {
        return values(STLTSA_INFO_LOCAL_VARIANCE, stltsa_dimension_local_variances);
    }
    Info info() const noexcept { return Info(stltsa_dimension_info(get())); }
    std::string json() const { return detail::json(stltsa_dimension_json, get()); }

    const stltsa_dimension* get() const noexcept { return handle_.get(); }

  private:
    template <class Get>
    Estimate estimate(Get of) const {
        const char* reason = "";
        const std::int64_t dimension = of(get(), &reason);
        return {dimension, reason};
    }
    template <class Fill>
    std::vector<double> values(std::int32_t key, Fill fill) const {
        return detail::matrix(fill, get(), info().count(key), 1).values;
    }

    detail::Handle<stltsa_dimension, stltsa_dimension_free> handle_;
};

inline Dimension estimate_dimension(const MatrixView& frames, const Options& options = {},
                                    Lengths lengths = {}) {
    return detail::made_of_rows<Dimension>(stltsa_estimate_dimension, frames, options, lengths);
}
inline Dimension estimate_dimension(const Clip& clip, const Options& options = {}) {
    return detail::made<Dimension>(stltsa_estimate_dimension_clip, clip.get(), options.get());
}
inline Dimension estimate_dimension(std::span<const Clip> clips, const Options& options = {}) {
    return detail::made_of_clips<Dimension>(stltsa_estimate_dimension_clips, clips, options);
}

class Decomposition {
  public:
    using Pointer = stltsa_decomposition*;

    explicit Decomposition(stltsa_decomposition* owned) : handle_(owned) {}

    std::int64_t unit_count() const noexcept { return stltsa_decomposition_unit_count(get()); }
    Interval unit(std::int64_t index) const {
        return detail::got<Interval>(stltsa_decomposition_unit, get(), index);
    }
    std::vector<Interval> units() const {
        return detail::list(unit_count(), [this](std::int64_t index) { return unit(index); });
    }
    std::int64_t segment_count() const noexcept {
        return stltsa_decomposition_segment_count(get());
    }
    Segment segment(std::int64_t index) const {
        return detail::got<Segment>(stltsa_decomposition_segment, get(), index);
    }
    std::vector<Segment> segments() const {
        return detail::list(segment_count(), [this](std::int64_t index) { return segment(index); });
    }
    /// Why the segment has no cycles; empty if it has.
    std::string segment_reason(std::int64_t index) const {
        return stltsa_decomposition_segment_reason(get(), index);
    }
    /// How similar the segments of two labels are, 0 to 1, or NaN; see
    /// stltsa_decomposition_label_likeness(). Throws if a label is out of range.
    double label_likeness(std::int32_t label, std::int32_t other) const {
        double found = 0;
        detail::check(stltsa_decomposition_label_likeness(get(), label, other, &found));
        return found;
    }
    /// Share of a cycle of the segment that the first step takes, and how far its 95 % interval
    /// reaches to each side; NaN: see stltsa_decomposition_first_step().
    std::pair<double, double> first_step(std::int64_t segment) const {
        std::pair<double, double> found;
        detail::check(stltsa_decomposition_first_step(get(), segment, &found.first, &found.second));
        return found;
    }
    /// Why the cycles of the segment have no steps; empty if they have.
    std::string steps_reason(std::int64_t segment) const {
        return stltsa_decomposition_steps_reason(get(), segment);
    }
    /// STLTSA_SIDE_* of side 0 or 1 of cycles and steps.
    std::int32_t side(std::int32_t of) const { return stltsa_decomposition_side(get(), of); }
    /// What moves in the segment, most first.
    std::vector<std::string> carriers(std::int64_t segment) const {
        return detail::list(stltsa_decomposition_carrier_count(get(), segment),
                            [this, segment](std::int64_t index) {
                                return std::string(
                                    stltsa_decomposition_carrier(get(), segment, index));
                            });
    }
    std::int64_t part_count(std::int32_t kind) const noexcept {
        return stltsa_decomposition_part_count(get(), kind);
    }
    Part part(std::int32_t kind, std::int64_t index) const {
        return detail::got<Part>(stltsa_decomposition_part, get(), kind, index);
    }
    /// STLTSA_PART_*
    std::vector<Part> parts(std::int32_t kind) const {
        return detail::list(part_count(kind),
                            [this, kind](std::int64_t index) { return part(kind, index); });
    }
    /// How the body travels during a part.
    Travel travel(std::int32_t kind, std::int64_t index) const {
        return detail::got<Travel>(stltsa_decomposition_travel, get(), kind, index);
    }
    /// STLTSA_PART_*, STLTSA_QUANTITY_*; side -1: both.
    Statistics statistics(std::int32_t kind, std::int32_t label, std::int32_t side,
                          std::int32_t quantity) const {
        return detail::got<Statistics>(stltsa_decomposition_statistics, get(), kind, label, side,
                                       quantity);
    }
    std::int64_t summary_count() const noexcept {
        return stltsa_decomposition_summary_count(get());
    }
    Summary summary(std::int64_t index) const {
        return detail::got<Summary>(stltsa_decomposition_summary, get(), index);
    }
    std::vector<Summary> summaries() const {
        return detail::list(summary_count(), [this](std::int64_t index) { return summary(index); });
    }
    std::int64_t cycle_count() const noexcept { return stltsa_decomposition_cycle_count(get()); }
    Interval cycle(std::int64_t index) const {
        return detail::got<Interval>(stltsa_decomposition_cycle, get(), index);
    }
    std::vector<Interval> cycles() const {
        return detail::list(cycle_count(), [this](std::int64_t index) { return cycle(index); });
    }
    /// Writes a report of the clip that was decomposed. `options`: those of stltsa::decompose().
    /// `command`: the command or call that makes the report again; empty: unknown.
    void save_report(const Clip& clip, const std::string& path, const std::string& command = {},
                     const Options& options = {}) const {
        detail::check(stltsa_report_save(clip.get(), get(), options.get(),
                                         command.empty() ? nullptr : command.c_str(),
                                         path.c_str()));
    }
    Matrix curve() const { return samples(stltsa_decomposition_curve, 1); }
    Matrix coords() const { return samples(stltsa_decomposition_coords, 2); }
    Matrix loop() const { return samples(stltsa_decomposition_loop, 2); }
    std::string reason() const { return stltsa_decomposition_reason(get()); }
    std::vector<std::string> warnings() const {
        return detail::texts(stltsa_decomposition_warning_count, stltsa_decomposition_warning,
                             get());
    }
    Info info() const noexcept { return Info(stltsa_decomposition_info(get())); }
    std::string json() const { return detail::json(stltsa_decomposition_json, get()); }

    const stltsa_decomposition* get() const noexcept { return handle_.get(); }

  private:
    template <class Fill>
    Matrix samples(Fill fill, std::int64_t cols) const {
        return detail::matrix(fill, get(), info().integer(STLTSA_INFO_ROWS), cols);
    }

    detail::Handle<stltsa_decomposition, stltsa_decomposition_free> handle_;
};

inline Decomposition decompose(const Clip& clip, const Options& options = {}) {
    return detail::made<Decomposition>(stltsa_decompose, clip.get(), options.get());
}

/// The side that the name of an event, a joint or a signal states, STLTSA_SIDE_*.
inline std::int32_t side_of_name(const std::string& name) noexcept {
    return stltsa_side_of_name(name.c_str());
}

/// The cycles of two motions, aligned by phase. `which`: 0 for the first motion, 1 for the second.
class Comparison {
  public:
    using Pointer = stltsa_comparison*;

    explicit Comparison(stltsa_comparison* owned) : handle_(owned) {}

    ComparedCycles cycles() const {
        ComparedCycles cycles{};
        cycles.size = sizeof cycles;
        detail::check(stltsa_comparison_cycles(get(), &cycles));
        return cycles;
    }
    /// Joints, points or columns of the file.
    std::int64_t part_count() const noexcept { return stltsa_comparison_part_count(get()); }
    ComparedPart part(std::int64_t index) const {
        ComparedPart part{};
        part.size = sizeof part;
        detail::check(stltsa_comparison_part(get(), index, &part));
        return part;
    }
    std::vector<ComparedPart> parts() const {
        return detail::list(part_count(), [this](std::int64_t index) { return part(index); });
    }
    std::string part_name(std::int32_t which, std::int64_t index) const {
        return stltsa_comparison_part_name(get(), which, index);
    }
    /// Coordinates of the parts.
    std::int64_t channel_count() const noexcept { return stltsa_comparison_channel_count(get()); }
    ComparedPart channel(std::int64_t index) const {
        ComparedPart channel{};
        channel.size = sizeof channel;
        detail::check(stltsa_comparison_channel(get(), index, &channel));
        return channel;
    }
    std::vector<ComparedPart> channels() const {
        return detail::list(channel_count(), [this](std::int64_t index) { return channel(index); });
    }
    /// Empty for the only channel of a part.
    std::string channel_axis(std::int64_t index) const {
        return stltsa_comparison_channel_axis(get(), index);
    }
    /// Mean cycle and standard deviation between cycles, samples x channels.
    Matrix mean(std::int32_t which) const {
        return samples_by_channels([&](const stltsa_out* to) {
            return stltsa_comparison_curves(get(), which, to, nullptr);
        });
    }
    Matrix deviation(std::int32_t which) const {
        return samples_by_channels([&](const stltsa_out* to) {
            return stltsa_comparison_curves(get(), which, nullptr, to);
        });
    }
    /// Second minus first, samples x channels.
    Matrix difference() const {
        return samples_by_channels([&](const stltsa_out* to) {
            return stltsa_comparison_difference(get(), to, nullptr, nullptr);
        });
    }
    Matrix standard_error() const {
        return samples_by_channels([&](const stltsa_out* to) {
            return stltsa_comparison_difference(get(), nullptr, to, nullptr);
        });
    }
    /// Half the width of the interval at each sample.
    Matrix margin() const {
        return samples_by_channels([&](const stltsa_out* to) {
            return stltsa_comparison_difference(get(), nullptr, nullptr, to);
        });
    }
    /// Names in this clip that the other one lacks.
    std::vector<std::string> left_out(std::int32_t which) const {
        std::vector<std::string> names;
        for (std::int64_t i = 0; i < stltsa_comparison_left_out_count(get(), which); ++i)
            names.emplace_back(stltsa_comparison_left_out(get(), which, i));
        return names;
    }
    std::vector<std::string> warnings() const {
        return detail::texts(stltsa_comparison_warning_count, stltsa_comparison_warning, get());
    }
    /// Writes a report: one HTML page. `command`: which repeats it; empty: unknown.
    void save_report(const std::string& path, const std::string& command = {}) const {
        detail::check(stltsa_comparison_report_save(
            get(), command.empty() ? nullptr : command.c_str(), path.c_str()));
    }
    std::string json() const { return detail::json(stltsa_comparison_json, get()); }

    const stltsa_comparison* get() const noexcept { return handle_.get(); }

  private:
    template <class Write>
    Matrix samples_by_channels(Write write) const {
        Matrix values(cycles().samples, channel_count());
        const stltsa_out to = detail::out(values);
        detail::check(write(&to));
        return values;
    }

    detail::Handle<stltsa_comparison, stltsa_comparison_free> handle_;
};

/// Signals on 0 to 100 % of each cycle.
class Cycles {
  public:
    using Pointer = stltsa_cycles*;

    Cycles(stltsa_cycles* owned, std::int64_t samples, std::int64_t columns)
        : handle_(owned), samples_(samples), columns_(columns) {}

    std::int64_t count() const noexcept { return stltsa_cycles_count(get()); }
    /// samples x columns
    Matrix mean() const {
        Matrix mean(samples_, columns_);
        const stltsa_out to = detail::out(mean);
        detail::check(stltsa_cycles_mean(get(), &to, nullptr));
        return mean;
    }
    /// Standard deviation, samples x columns.
    Matrix deviation() const {
        Matrix deviation(samples_, columns_);
        const stltsa_out to = detail::out(deviation);
        detail::check(stltsa_cycles_mean(get(), nullptr, &to));
        return deviation;
    }
    /// samples x columns
    Matrix cycle(std::int64_t index) const {
        Matrix values(samples_, columns_);
        const stltsa_out to = detail::out(values);
        detail::check(stltsa_cycles_cycle(get(), index, &to));
        return values;
    }
    /// The frame of each sample, cycles x samples.
    Matrix frames() const {
        Matrix frames(count(), samples_);
        const stltsa_out to = detail::out(frames);
        detail::check(stltsa_cycles_times(get(), &to, nullptr));
        return frames;
    }
    /// How much later each sample is than in linear time, as a share of the cycle.
    Matrix warp() const {
        Matrix warp(count(), samples_);
        const stltsa_out to = detail::out(warp);
        detail::check(stltsa_cycles_times(get(), nullptr, &to));
        return warp;
    }
    /// Of each cycle, as a share of the deviation along the mean cycle.
    std::vector<double> distance() const {
        std::vector<double> total(static_cast<std::size_t>(count()));
        const stltsa_out to = detail::out(total);
        detail::check(stltsa_cycles_distance(get(), &to, nullptr));
        return total;
    }
    /// The same for each column, in its unit: cycles x columns.
    Matrix column_distance() const {
        Matrix columns(count(), columns_);
        const stltsa_out to = detail::out(columns);
        detail::check(stltsa_cycles_distance(get(), nullptr, &to));
        return columns;
    }

    /// The same for groups of columns: `groups` has that of each column, -1 for none.
    Matrix group_distance(const std::vector<std::int64_t>& groups) const {
        std::int64_t most = -1;
        for (const std::int64_t group : groups)
            most = std::max(most, group);
        Matrix distance(count(), most + 1);
        const detail::List given(groups);
        const stltsa_out to = detail::out(distance);
        detail::check(stltsa_cycles_group_distance(get(), given.get(), &to));
        return distance;
    }
    /// Compares left with right. `names`: one for each column, such as knee_l and knee_r. `fps`:
    /// frames per second; 0: unknown, so that times are NaN.
    Comparison compare_left_right(const std::vector<std::string>& names, double fps = 0,
                                  const Options& options = {}) const {
        if (static_cast<std::int64_t>(names.size()) != columns_)
            throw Error(STLTSA_E_SHAPE, "names has " + std::to_string(names.size()) +
                                            " entries; there are " + std::to_string(columns_) +
                                            " columns");
        std::vector<const char*> texts;
        for (const std::string& name : names)
            texts.push_back(name.c_str());
        return detail::made<Comparison>(stltsa_cycles_compare_left_right, get(), texts.data(), fps,
                                        options.get());
    }

    const stltsa_cycles* get() const noexcept { return handle_.get(); }

  private:
    detail::Handle<stltsa_cycles, stltsa_cycles_free> handle_;
    std::int64_t samples_, columns_;
};

/// Moments that were marked once, wherever they come again.
class Events {
  public:
    using Pointer = stltsa_events*;

    explicit Events(stltsa_events* owned) : handle_(owned) {}

    std::int64_t count() const noexcept { return stltsa_events_count(get()); }
    Event event(std::int64_t index) const {
        Event event{};
        event.size = sizeof event;
        detail::check(stltsa_events_event(get(), index, &event));
        return event;
    }
    std::vector<Event> all() const {
        return detail::list(count(), [this](std::int64_t index) { return event(index); });
    }
    double likeness() const noexcept { return stltsa_events_likeness(get()); }
    std::vector<std::string> warnings() const {
        return detail::texts(stltsa_events_warning_count, stltsa_events_warning, get());
    }

    const stltsa_events* get() const noexcept { return handle_.get(); }

  private:
    detail::Handle<stltsa_events, stltsa_events_free> handle_;
};

/// A phase for every frame of the cycles of a clip.
class Phase {
  public:
    using Pointer = stltsa_phase*;

    Phase(stltsa_phase* owned, std::int64_t frames) : handle_(owned), frames_(frames) {}

    /// Of each frame, in [0, 1); NaN outside cycles.
    std::vector<double> values() const {
        std::vector<double> values(static_cast<std::size_t>(frames_));
        const stltsa_out to = detail::out(values);
        detail::check(stltsa_phase_values(get(), &to, nullptr, nullptr));
        return values;
    }
    std::vector<double> residuals() const {
        std::vector<double> residuals(static_cast<std::size_t>(frames_));
        const stltsa_out to = detail::out(residuals);
        detail::check(stltsa_phase_values(get(), nullptr, &to, nullptr));
        return residuals;
    }
    /// Index of the cycle of each frame; -1 outside cycles.
    std::vector<std::int64_t> cycles() const {
        std::vector<std::int64_t> cycles(static_cast<std::size_t>(frames_));
        const stltsa_out to = detail::out(cycles);
        detail::check(stltsa_phase_values(get(), nullptr, nullptr, &to));
        return cycles;
    }
    std::vector<std::string> warnings() const {
        return detail::texts(stltsa_phase_warning_count, stltsa_phase_warning, get());
    }
    /// Where the body is at the same place in every clip; `label`: 0 for A.
    double zero(std::int32_t label) const {
        double zero = 0;
        detail::check(stltsa_phase_zero(get(), label, &zero));
        return zero;
    }
    /// The joint, point or column of the file that each column of the features belongs to.
    std::vector<std::string> column_owners() const {
        return detail::texts(stltsa_phase_column_count, stltsa_phase_column_owner, get());
    }
    /// The event at marked frames, in every cycle of the clip.
    Events events(const std::vector<double>& marks) const { return events(marks, *this); }
    /// The same in another clip.
    Events events(const std::vector<double>& marks, const Phase& in,
                  const Options& options = {}) const {
        const MatrixView at(marks, 1);
        stltsa_events* events = nullptr;
        detail::check(stltsa_events_find_with(get(), at.get(), in.get(), options.get(), &events));
        return Events(events);
    }
    /// `label`: of the segments, 0 for A.
    Cycles resample(std::int32_t label, const MatrixView& signals,
                    std::int64_t samples = 101) const {
        stltsa_cycles* cycles = nullptr;
        detail::check(stltsa_cycles_resample(get(), label, signals.get(), samples, &cycles));
        return {cycles, samples, signals.get()->cols};
    }

    /// Compares a cyclic motion of this clip with one of another. Labels: of the segments, 0 for A;
    /// -1: the longest such motion here, and there the one most like it.
    Comparison compare(const Phase& second, std::int32_t label = -1, std::int32_t second_label = -1,
                       std::int64_t samples = 101, const Options& options = {}) const {
        stltsa_comparison* comparison = nullptr;
        detail::check(stltsa_compare_with(get(), label, second.get(), second_label, samples,
                                          options.get(), &comparison));
        return Comparison(comparison);
    }
    /// Compares left with right. `clip`: the clip that the phase was found in.
    Comparison compare_left_right(const Clip& clip, std::int32_t label = -1,
                                  const Options& options = {}, std::int64_t samples = 101) const {
        stltsa_comparison* comparison = nullptr;
        detail::check(stltsa_compare_left_right(clip.get(), get(), label, samples, options.get(),
                                                &comparison));
        return Comparison(comparison);
    }

    const stltsa_phase* get() const noexcept { return handle_.get(); }

  private:
    detail::Handle<stltsa_phase, stltsa_phase_free> handle_;
    std::int64_t frames_;
};

/// Follows one stream of frames.
class Live {
  public:
    using Pointer = stltsa_live*;

    explicit Live(const Model& model) : handle_(made(model)) {}

    std::vector<std::string> marks() const {
        return detail::texts(stltsa_live_mark_count, stltsa_live_mark_name, get());
    }
    LiveFrame push(double seconds, const MatrixView& features) {
        return answer(stltsa_live_push, seconds, features.get());
    }
    /// Points in space or in a plane, a row each; `confidence`: one number for each, 0: lost.
    LiveFrame push_points(double seconds, const MatrixView& points) {
        return answer(stltsa_live_push_points, seconds, points.get(), nullptr);
    }
    LiveFrame push_points(double seconds, const MatrixView& points, const MatrixView& confidence) {
        return answer(stltsa_live_push_points, seconds, points.get(), confidence.get());
    }
    /// Local rotations of the joints, in a form STLTSA_ROTATIONS_*.
    LiveFrame push_pose(double seconds, std::int32_t form, const MatrixView& rotations) {
        return answer(stltsa_live_push_pose, seconds, form, rotations.get(), nullptr);
    }
    LiveFrame push_pose(double seconds, std::int32_t form, const MatrixView& rotations,
                        const MatrixView& root) {
        return answer(stltsa_live_push_pose, seconds, form, rotations.get(), root.get());
    }
    /// A frame of a clip; its other frames are not looked at.
    LiveFrame push(double seconds, const Clip& clip, std::int64_t index) {
        return answer(stltsa_live_push_frame, seconds, clip.get(), index);
    }

    const stltsa_live* get() const noexcept { return handle_.get(); }

  private:
    template <class Push, class... Frame>
    LiveFrame answer(Push call, double seconds, Frame... given) {
        LiveFrame frame{};
        frame.size = sizeof frame;
        detail::check(call(handle_.get(), seconds, given..., &frame));
        return frame;
    }
    static stltsa_live* made(const Model& model) {
        stltsa_live* live = nullptr;
        detail::check(stltsa_live_new(model.get(), &live));
        return live;
    }

    detail::Handle<stltsa_live, stltsa_live_free> handle_;
};

/// Keeps the mean cycle in the model, for Live.
inline void keep_cycle(Model& model, const Phase& phase) {
    detail::check(stltsa_model_keep_cycle(model.get(), phase.get()));
}
/// Names the phase of a frame.
inline void keep_mark(Model& model, const Phase& phase, double frame, const std::string& name) {
    detail::check(stltsa_model_keep_mark(model.get(), phase.get(), frame, name.c_str()));
}

/// Found by the first call, and kept by the decomposition. `options`: progress.
inline Phase find_phase(const Decomposition& decomposition, const Options& options = {}) {
    stltsa_phase* phase = nullptr;
    detail::check(stltsa_phase_find(decomposition.get(), options.get(), &phase));
    return {phase, decomposition.info().integer(STLTSA_INFO_CLIP_FRAMES)};
}

/// Linear in time between the borders.
inline Cycles cycles_between(const std::vector<double>& borders, const MatrixView& signals,
                             std::int64_t samples = 101) {
    const MatrixView at(borders, 1);
    stltsa_cycles* cycles = nullptr;
    detail::check(stltsa_cycles_between(at.get(), signals.get(), samples, &cycles));
    return {cycles, samples, signals.get()->cols};
}

class Denoising {
  public:
    using Pointer = stltsa_denoising*;

    explicit Denoising(stltsa_denoising* owned) : handle_(owned) {}

    Matrix curve() const { return table(stltsa_denoising_curve); }
    Matrix cleaned() const { return table(stltsa_denoising_cleaned); }
    Matrix moves() const { return table(stltsa_denoising_moves); }
    Info info() const noexcept { return Info(stltsa_denoising_info(get())); }
    std::string json() const { return detail::json(stltsa_denoising_json, get()); }

    const stltsa_denoising* get() const noexcept { return handle_.get(); }

  private:
    template <class Fill>
    Matrix table(Fill fill) const {
        return detail::matrix(fill, get(), info().integer(STLTSA_INFO_ROWS),
                              info().integer(STLTSA_INFO_COLUMNS));
    }

    detail::Handle<stltsa_denoising, stltsa_denoising_free> handle_;
};

inline Denoising denoise(const MatrixView& coords, const Options& options = {},
                         Lengths lengths = {}) {
    return detail::made_of_rows<Denoising>(stltsa_denoise, coords, options, lengths);
}
inline Denoising denoise(const Model& model, const Options& options = {}) {
    return detail::made<Denoising>(stltsa_denoise_model, model.get(), options.get());
}

class Synthesis {
  public:
    using Pointer = stltsa_synthesis*;

    explicit Synthesis(stltsa_synthesis* owned)
        : handle_(owned), clip_(stltsa_synthesis_clip(owned)) {}

    /// The new clip; valid as long as this object.
    const Clip& clip() const noexcept { return clip_; }
    std::int64_t seam_count() const noexcept { return stltsa_synthesis_seam_count(get()); }
    Seam seam(std::int64_t index) const {
        Seam seam{};
        seam.size = sizeof seam;
        detail::check(stltsa_synthesis_seam(get(), index, &seam));
        return seam;
    }
    std::vector<Seam> seams() const {
        return detail::list(seam_count(), [this](std::int64_t index) { return seam(index); });
    }
    std::vector<std::string> warnings() const {
        return detail::texts(stltsa_synthesis_warning_count, stltsa_synthesis_warning, get());
    }
    Info info() const noexcept { return Info(stltsa_synthesis_info(get())); }
    std::string json() const { return detail::json(stltsa_synthesis_json, get()); }

    const stltsa_synthesis* get() const noexcept { return handle_.get(); }

  private:
    detail::Handle<stltsa_synthesis, stltsa_synthesis_free> handle_;
    Clip clip_;
};

inline Synthesis synthesize(std::span<const Piece> pieces, const Options& options = {}) {
    return detail::made<Synthesis>(stltsa_synthesize, pieces.data(),
                                   static_cast<std::int64_t>(pieces.size()), options.get());
}
/// The loop of the most cycles of a clip whose ends meet.
inline Synthesis synthesize_loop(const Clip& clip, const Decomposition& decomposition,
                                 const Options& options = {}) {
    return detail::made<Synthesis>(stltsa_synthesize_loop, clip.get(), decomposition.get(),
                                   options.get());
}

} // namespace v0
} // namespace stltsa

#endif // STLTSA_HPP
