// SPDX-License-Identifier: BSD-3-Clause
// libstltsa for C++20: stltsa.h with move-only handles, exceptions, std::string and std::span.
// stltsa.h documents each function and its options.
//
//     const stltsa::Clip clip = stltsa::Clip::open("walk.bvh");
//     for (const stltsa::Unit& unit : stltsa::decompose(clip).units())
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

// Rows of lists: the texts in them are valid as long as the object that they came from.
using Warning = stltsa_warning;
using Joint = stltsa_joint; ///< also input
using FileEvent = stltsa_file_event;
using Component = stltsa_component;
using Segment = stltsa_segment;
using Unit = stltsa_unit;
using Part = stltsa_part;
using Summary = stltsa_summary;
using Event = stltsa_event;
using Compared = stltsa_compared;
using ComparedMotion = stltsa_compared_motion;
using ComparedPart = stltsa_compared_part;
using DenoisedColumn = stltsa_denoised_column;
using Seam = stltsa_seam;
using PieceFact = stltsa_piece_fact;

using Interval = stltsa_interval;
using Statistics = stltsa_statistics;
using Estimate = stltsa_estimate;
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
    const std::exception_ptr by_callback = std::exchange(thrown(), nullptr);
    if (by_callback && status == STLTSA_E_CANCELLED)
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

/// The texts as C takes them, valid as long as they are unchanged.
inline std::vector<const char*> pointers(const std::vector<std::string>& texts) {
    std::vector<const char*> all;
    for (const std::string& text : texts)
        all.push_back(text.c_str());
    return all;
}

/// The results of item(index) for 0 to count - 1.
template <class Item>
auto list(std::int64_t count, Item item) {
    std::vector<decltype(item(count))> items;
    for (std::int64_t i = 0; i < count; ++i)
        items.push_back(item(i));
    return items;
}

/// The rows that describe(index, &row) gives until it fails.
template <class Row, class Describe>
std::vector<Row> table(Describe describe) {
    std::vector<Row> rows;
    Row row{};
    for (row.size = sizeof row; describe(std::ssize(rows), &row) == STLTSA_OK;)
        rows.push_back(row);
    return rows;
}

inline const char* text_or_null(const std::string& text) noexcept {
    return text.empty() ? nullptr : text.c_str();
}

} // namespace detail

inline std::string version() {
    return stltsa_version();
}
/// Whether this build has the part STLTSA_HAS_*.
inline bool has(std::int32_t part) noexcept {
    return stltsa_has(part) != 0;
}
inline std::string status_name(stltsa_status status) {
    return stltsa_status_name(status);
}
inline std::string segment_name(std::int64_t kind) {
    return stltsa_segment_name(kind);
}
inline std::string unit_name(std::int64_t kind) {
    return stltsa_unit_name(kind);
}
/// The side of the body that the name of an event, a joint or a signal states, STLTSA_SIDE_*.
inline std::int32_t side_of_name(const std::string& name) noexcept {
    return stltsa_side_of_name(name.c_str());
}
/// One row for each option.
inline std::vector<OptionInfo> option_table() {
    return detail::table<OptionInfo>(stltsa_option_describe);
}
/// One row for each key of Info.
inline std::vector<InfoKey> info_table() {
    return detail::table<InfoKey>(stltsa_info_describe);
}

/// Facts, lists and arrays by key, as info() of an object gives them; valid as long as the object.
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
    /// Row: the struct that the key names.
    template <class Row>
    std::vector<Row> rows(std::int32_t key) const {
        std::vector<Row> all(static_cast<std::size_t>(count(key)));
        if (!all.empty())
            detail::check(stltsa_info_rows(info_, key, 0, count(key), all.data(), sizeof(Row)));
        return all;
    }
    Matrix array(std::int32_t key, std::int64_t index = 0) const {
        Matrix values;
        detail::check(stltsa_info_shape(info_, key, &values.rows, &values.cols));
        values = Matrix(values.rows, values.cols);
        const stltsa_out to = detail::out(values);
        detail::check(stltsa_info_array(info_, key, index, &to));
        return values;
    }
    std::string json() const {
        const detail::Handle<char, stltsa_free> text(detail::got<char*>(stltsa_info_json, info_));
        return text.get();
    }

  private:
    const stltsa_info* info_;
};

/// What all results have in common.
template <class T, auto free_handle, auto info_of>
class Result {
  public:
    using Pointer = T*;

    explicit Result(T* owned) : handle_(owned) {}

    Info info() const noexcept { return Info(info_of(get())); }
    std::string json() const { return info().json(); }
    std::vector<Warning> warnings() const {
        return info().template rows<Warning>(STLTSA_INFO_WARNING);
    }

    T* get() noexcept { return handle_.get(); }
    const T* get() const noexcept { return handle_.get(); }

  private:
    detail::Handle<T, free_handle> handle_;
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
    /// The clip, or a stretch of it, such as "walk.bvh:cyclic"; see stltsa_clip_open_stretch.
    static Clip open_stretch(const std::string& text, const Options& options = {}) {
        return detail::made<Clip>(stltsa_clip_open_stretch, text.c_str(), options.get());
    }
    /// If `format` is 0, the content decides. `name`: see stltsa_clip_parse; empty: none.
    static Clip parse(std::span<const std::byte> bytes, std::int32_t format = 0,
                      const Options& options = {}, const std::string& name = {}) {
        return detail::made<Clip>(stltsa_clip_parse, bytes.data(), bytes.size(), format,
                                  detail::text_or_null(name), options.get());
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
        const std::vector<const char*> names = detail::pointers(points.names);
        given.names = names.empty() ? nullptr : names.data();
        if (points.confidence)
            given.confidence = *points.confidence->get();
        if (points.times)
            given.times = *points.times->get();
        given.fps = points.fps;
        return detail::made<Clip>(stltsa_clip_from_points, &given, options.get());
    }
    /// See stltsa_clip_from_skeleton; `form` is one of STLTSA_ROTATIONS_*.
    static Clip from_skeleton(std::span<const Joint> joints, std::int32_t form,
                              const MatrixView& rotations,
                              const std::optional<MatrixView>& root_positions, double fps) {
        return detail::made<Clip>(stltsa_clip_from_skeleton, joints.data(), sizeof(Joint),
                                  std::ssize(joints), form, rotations.get(),
                                  root_positions ? root_positions->get() : nullptr, fps);
    }

    /// See stltsa_clip_set_path. Throws Error if the clip belongs to a result.
    void set_path(const std::string& path) {
        stltsa_clip* const owned = handle_ ? handle_.get_deleter().owned : nullptr;
        detail::check(stltsa_clip_set_path(owned, path.c_str()));
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
    std::vector<Joint> joints() const { return info().rows<Joint>(STLTSA_INFO_JOINT); }
    /// Events that the file states, in order of time.
    std::vector<FileEvent> events() const { return info().rows<FileEvent>(STLTSA_INFO_FILE_EVENT); }
    Matrix positions() const { return info().array(STLTSA_INFO_POSITIONS); }
    Matrix rotations() const { return info().array(STLTSA_INFO_ROTATIONS); }
    std::int64_t feature_count(const Options& options = {}) const {
        return detail::got<std::int64_t>(stltsa_clip_feature_count, get(), options.get());
    }
    Matrix features(const Options& options = {}) const {
        Matrix values(frames(), feature_count(options));
        const stltsa_out to = detail::out(values);
        detail::check(stltsa_clip_features(get(), options.get(), &to));
        return values;
    }
    Info info() const noexcept { return Info(stltsa_clip_info(get())); }
    std::string json() const { return info().json(); }
    void save(const std::string& path, const Options& options = {}) const {
        detail::check(stltsa_clip_save(get(), path.c_str(), options.get()));
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

class Model : public Result<stltsa_model, stltsa_model_free, stltsa_model_info> {
  public:
    using Result::Result;
    using Hints = std::span<const std::int64_t>; ///< empty: none

    static Model load(const std::string& path, const Options& options = {}) {
        return detail::made<Model>(stltsa_model_load, path.c_str(), options.get());
    }
    static Model parse(std::span<const std::byte> bytes) {
        return detail::made<Model>(stltsa_model_parse, bytes.data(), bytes.size());
    }
    void save(const std::string& path, const Options& options = {}) const {
        detail::check(stltsa_model_save(get(), path.c_str(), options.get()));
    }
    std::vector<std::byte> serialize() const {
        unsigned char* bytes = nullptr;
        std::size_t size = 0;
        detail::check(stltsa_model_serialize(get(), &bytes, &size));
        const detail::Handle<unsigned char, stltsa_free> owner(bytes);
        const auto all = std::as_bytes(std::span(bytes, size));
        return {all.begin(), all.end()};
    }

    Matrix coords() const { return info().array(STLTSA_INFO_COORDS); }
    Matrix eigenvalues() const { return info().array(STLTSA_INFO_EIGENVALUES); }
    std::vector<Component> components() const {
        return info().rows<Component>(STLTSA_INFO_COMPONENT);
    }
    /// The component of each row.
    std::vector<std::int64_t> component_of() const {
        const Matrix found = info().array(STLTSA_INFO_COMPONENT_OF);
        return {found.values.begin(), found.values.end()};
    }
    Mapped map(const MatrixView& frames, const Options& options = {}, Hints hints = {}) const {
        return mapped(stltsa_map, frames.rows(), info().integer(STLTSA_INFO_DIMENSION),
                      frames.get(), detail::List(hints).get(), options.get());
    }
    Mapped map(const Clip& clip, const Options& options = {}) const {
        return mapped(stltsa_map_clip, clip.frames(), info().integer(STLTSA_INFO_DIMENSION),
                      clip.get(), options.get());
    }
    Mapped unmap(const MatrixView& coords, const Options& options = {}, Hints hints = {}) const {
        return mapped(stltsa_unmap, coords.rows(), info().integer(STLTSA_INFO_FEATURE_COUNT),
                      coords.get(), detail::List(hints).get(), options.get());
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
    /// For Live.
    bool has_cycle() const { return info().integer(STLTSA_INFO_HAS_CYCLE) != 0; }

  private:
    static Mapped room(std::int64_t rows, std::int64_t cols) {
        const auto count = static_cast<std::size_t>(rows);
        return {Matrix(rows, cols), std::vector<double>(count), std::vector<std::int64_t>(count)};
    }
    template <class Map, class... In>
    Mapped mapped(Map call, std::int64_t rows, std::int64_t cols, In... in) const {
        Mapped result = room(rows, cols);
        const stltsa_out values = detail::out(result.values);
        const stltsa_out distance = detail::out(result.distance);
        const stltsa_out nearest = detail::out(result.nearest);
        detail::check(call(get(), in..., &values, &distance, &nearest));
        return result;
    }
};

/// Frames of each clip, if several follow each other in a matrix; empty: one clip.
using Lengths = std::span<const std::int64_t>;

inline Model fit(const MatrixView& frames, const Options& options = {}, Lengths lengths = {}) {
    return detail::made<Model>(stltsa_fit, frames.get(), detail::List(lengths).get(),
                               options.get());
}
inline Model fit(const Clip& clip, const Options& options = {}) {
    const stltsa_clip* const one = clip.get();
    return detail::made<Model>(stltsa_fit_clips, &one, std::int64_t{1}, options.get());
}
/// Several clips, each prepared separately.
inline Model fit(std::span<const Clip> clips, const Options& options = {}) {
    std::vector<const stltsa_clip*> handles;
    for (const Clip& clip : clips)
        handles.push_back(clip.get());
    return detail::made<Model>(stltsa_fit_clips, handles.data(), std::ssize(handles),
                               options.get());
}

class Decomposition
    : public Result<stltsa_decomposition, stltsa_decomposition_free, stltsa_decomposition_info> {
  public:
    using Result::Result;

    std::vector<Segment> segments() const { return info().rows<Segment>(STLTSA_INFO_SEGMENT); }
    std::vector<Unit> units() const { return info().rows<Unit>(STLTSA_INFO_UNIT); }
    std::vector<Part> cycles() const { return info().rows<Part>(STLTSA_INFO_CYCLE); }
    std::vector<Part> steps() const { return info().rows<Part>(STLTSA_INFO_STEP); }
    std::vector<Part> repetitions() const { return info().rows<Part>(STLTSA_INFO_REPETITION); }
    std::vector<Summary> summaries() const { return info().rows<Summary>(STLTSA_INFO_SUMMARY); }
    /// kind: STLTSA_INFO_CYCLE, _STEP or _REPETITION; STLTSA_QUANTITY_*; side -1: both.
    Statistics statistics(std::int32_t kind, std::int64_t label, std::int32_t side,
                          std::int32_t quantity) const {
        return detail::got<Statistics>(stltsa_decomposition_statistics, get(), kind, label, side,
                                       quantity);
    }
    /// Labels x labels; see STLTSA_INFO_LABEL_LIKENESS.
    Matrix label_likeness() const { return info().array(STLTSA_INFO_LABEL_LIKENESS); }
    /// Samples x 1, samples x 2.
    Matrix curve() const { return info().array(STLTSA_INFO_CURVE); }
    Matrix coords() const { return info().array(STLTSA_INFO_COORDS); }
    std::string reason() const { return info().text(STLTSA_INFO_REASON); }
    /// Writes a report of the clip that was decomposed or, if the path ends in .svg, a figure.
    /// `options`: those of stltsa::decompose(). `command`: what makes it again; empty: unknown.
    void save_report(const Clip& clip, const std::string& path, const std::string& command = {},
                     const Options& options = {}) const {
        detail::check(stltsa_report_save(clip.get(), get(), options.get(),
                                         detail::text_or_null(command), path.c_str()));
    }
};

inline Decomposition decompose(const Clip& clip, const Options& options = {}) {
    return detail::made<Decomposition>(stltsa_decompose, clip.get(), options.get());
}

/// The cycles of two motions, aligned by phase. `which`: 0 for the first motion, 1 for the second.
class Comparison
    : public Result<stltsa_comparison, stltsa_comparison_free, stltsa_comparison_info> {
  public:
    using Result::Result;

    Compared whole() const { return info().rows<Compared>(STLTSA_INFO_COMPARISON).at(0); }
    ComparedMotion motion(std::int32_t which) const {
        return info().rows<ComparedMotion>(STLTSA_INFO_MOTION).at(static_cast<std::size_t>(which));
    }
    /// Joints, points or columns of the file; and their coordinates.
    std::vector<ComparedPart> parts() const { return info().rows<ComparedPart>(STLTSA_INFO_PART); }
    std::vector<ComparedPart> channels() const {
        return info().rows<ComparedPart>(STLTSA_INFO_PART_CHANNEL);
    }
    /// Mean cycle and standard deviation between cycles, samples x channels.
    Matrix mean(std::int32_t which) const { return info().array(STLTSA_INFO_MEAN, which); }
    Matrix deviation(std::int32_t which) const {
        return info().array(STLTSA_INFO_DEVIATION, which);
    }
    /// Second minus first, samples x channels; its standard error, and half the width of its
    /// interval at each sample.
    Matrix difference() const { return info().array(STLTSA_INFO_DIFFERENCE); }
    Matrix standard_error() const { return info().array(STLTSA_INFO_STANDARD_ERROR); }
    Matrix margin() const { return info().array(STLTSA_INFO_MARGIN); }
    /// Writes a report: one HTML page. `command`: what makes it again; empty: unknown.
    void save_report(const std::string& path, const std::string& command = {},
                     const Options& options = {}) const {
        detail::check(stltsa_comparison_report_save(get(), options.get(),
                                                    detail::text_or_null(command), path.c_str()));
    }
};

/// Signals on 0 to 100 % of each cycle.
class Cycles : public Result<stltsa_cycles, stltsa_cycles_free, stltsa_cycles_info> {
  public:
    using Result::Result;

    std::int64_t count() const noexcept { return info().count(STLTSA_INFO_VALUES); }
    /// These three are samples x columns.
    Matrix mean() const { return info().array(STLTSA_INFO_MEAN); }
    Matrix deviation() const { return info().array(STLTSA_INFO_DEVIATION); }
    Matrix cycle(std::int64_t index) const { return info().array(STLTSA_INFO_VALUES, index); }
    /// The frame of each sample, cycles x samples.
    Matrix frames() const { return info().array(STLTSA_INFO_SAMPLE_FRAMES); }
    /// How much later each sample is than in linear time, as a share of the cycle.
    Matrix warp() const { return info().array(STLTSA_INFO_WARP); }
    /// Of each cycle, as a share of the deviation along the mean cycle.
    std::vector<double> distance() const { return info().array(STLTSA_INFO_DISTANCE).values; }
    /// The same for each column, in its unit: cycles x columns.
    Matrix column_distance() const { return info().array(STLTSA_INFO_COLUMN_DISTANCE); }
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
        if (const std::int64_t columns = mean().cols;
            static_cast<std::int64_t>(names.size()) != columns)
            throw Error(STLTSA_E_SHAPE, "names has " + std::to_string(names.size()) +
                                            " entries; there are " + std::to_string(columns) +
                                            " columns");
        return detail::made<Comparison>(stltsa_cycles_compare_left_right, get(),
                                        detail::pointers(names).data(), fps, options.get());
    }
};

/// Moments that were marked once, wherever they come again.
class Events : public Result<stltsa_events, stltsa_events_free, stltsa_events_info> {
  public:
    using Result::Result;

    std::vector<Event> all() const { return info().rows<Event>(STLTSA_INFO_EVENT); }
    double likeness() const { return info().real(STLTSA_INFO_LIKENESS); }
};

/// A phase for every frame of the cycles of a clip.
class Phase : public Result<stltsa_phase, stltsa_phase_free, stltsa_phase_info> {
  public:
    using Result::Result;

    /// Of each frame, in [0, 1); NaN outside cycles.
    std::vector<double> values() const { return info().array(STLTSA_INFO_PHASE).values; }
    std::vector<double> residuals() const {
        return info().array(STLTSA_INFO_PHASE_RESIDUAL).values;
    }
    /// Index of the cycle of each frame; -1 outside cycles.
    std::vector<std::int64_t> cycles() const {
        const Matrix found = info().array(STLTSA_INFO_PHASE_CYCLE);
        return {found.values.begin(), found.values.end()};
    }
    /// Of each label: where the body is at the same place in every clip.
    std::vector<double> zeros() const { return info().reals(STLTSA_INFO_PHASE_ZERO); }
    /// The joint, point or column of the file that each column of the features belongs to.
    std::vector<std::string> column_owners() const { return info().texts(STLTSA_INFO_OWNER); }
    /// The event at marked frames, in every cycle of the clip.
    Events events(const std::vector<double>& marks) const { return events(marks, *this); }
    /// The same in another clip.
    Events events(const std::vector<double>& marks, const Phase& in,
                  const Options& options = {}) const {
        const MatrixView at(marks, 1);
        return detail::made<Events>(stltsa_events_find, get(), at.get(), in.get(), options.get());
    }
    /// `label`: of the segments, 0 for A.
    Cycles resample(std::int64_t label, const MatrixView& signals, std::int64_t samples = 101,
                    const Options& options = {}) const {
        return detail::made<Cycles>(stltsa_cycles_resample, get(), label, signals.get(), samples,
                                    options.get());
    }
    /// Compares a cyclic motion of this clip with one of another. Labels: of the segments, 0 for A;
    /// -1: the longest such motion here, and there the one most like it.
    Comparison compare(const Phase& second, std::int64_t label = -1, std::int64_t second_label = -1,
                       std::int64_t samples = 101, const Options& options = {}) const {
        return detail::made<Comparison>(stltsa_compare, get(), label, second.get(), second_label,
                                        samples, options.get());
    }
    /// Compares left with right. `clip`: the clip that the phase was found in.
    Comparison compare_left_right(const Clip& clip, std::int64_t label = -1,
                                  const Options& options = {}, std::int64_t samples = 101) const {
        return detail::made<Comparison>(stltsa_compare_left_right, clip.get(), get(), label,
                                        samples, options.get());
    }
};

/// Found by the first call, and kept by the decomposition. `options`: progress.
inline Phase find_phase(const Decomposition& decomposition, const Options& options = {}) {
    return detail::made<Phase>(stltsa_phase_find, decomposition.get(), options.get());
}
/// Linear in time between the borders.
inline Cycles cycles_between(const std::vector<double>& borders, const MatrixView& signals,
                             std::int64_t samples = 101, const Options& options = {}) {
    const MatrixView at(borders, 1);
    return detail::made<Cycles>(stltsa_cycles_between, at.get(), signals.get(), samples,
                                options.get());
}

/// Follows one stream of frames.
class Live : public Result<stltsa_live, stltsa_live_free, stltsa_live_info> {
  public:
    explicit Live(const Model& model)
        : Result(detail::got<stltsa_live*>(stltsa_live_new, model.get())) {}

    std::vector<std::string> marks() const { return info().texts(STLTSA_INFO_MARK); }
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

  private:
    template <class Push, class... Frame>
    LiveFrame answer(Push call, double seconds, Frame... given) {
        LiveFrame frame{};
        frame.size = sizeof frame;
        detail::check(call(get(), seconds, given..., &frame));
        return frame;
    }
};

/// Keeps the mean cycle in the model, for Live.
inline void keep_cycle(Model& model, const Phase& phase, const Options& options = {}) {
    detail::check(stltsa_model_keep_cycle(model.get(), phase.get(), options.get()));
}
/// Names the phase of a frame.
inline void keep_mark(Model& model, const Phase& phase, double frame, const std::string& name) {
    detail::check(stltsa_model_keep_mark(model.get(), phase.get(), frame, name.c_str()));
}

class Denoising : public Result<stltsa_denoising, stltsa_denoising_free, stltsa_denoising_info> {
  public:
    using Result::Result;

    std::vector<DenoisedColumn> columns() const {
        return info().rows<DenoisedColumn>(STLTSA_INFO_COLUMN);
    }
    /// Rows x columns.
    Matrix curve() const { return info().array(STLTSA_INFO_CURVE); }
    Matrix cleaned() const { return info().array(STLTSA_INFO_CLEANED); }
    Matrix moves() const { return info().array(STLTSA_INFO_MOVES); }
};

inline Denoising denoise(const MatrixView& coords, const Options& options = {},
                         Lengths lengths = {}) {
    return detail::made<Denoising>(stltsa_denoise, coords.get(), detail::List(lengths).get(),
                                   options.get());
}
inline Denoising denoise(const Model& model, const Options& options = {}) {
    return detail::made<Denoising>(stltsa_denoise_model, model.get(), options.get());
}

class Synthesis : public Result<stltsa_synthesis, stltsa_synthesis_free, stltsa_synthesis_info> {
  public:
    explicit Synthesis(stltsa_synthesis* owned)
        : Result(owned), clip_(stltsa_synthesis_clip(owned)) {}

    /// The new clip; valid as long as this object.
    const Clip& clip() const noexcept { return clip_; }
    std::vector<Seam> seams() const { return info().rows<Seam>(STLTSA_INFO_SEAM); }

  private:
    Clip clip_;
};

inline Synthesis synthesize(std::span<const Piece> pieces, const Options& options = {}) {
    return detail::made<Synthesis>(stltsa_synthesize, pieces.data(), std::ssize(pieces),
                                   options.get());
}
/// The loop of the most cycles of a clip whose ends meet.
inline Synthesis synthesize_loop(const Clip& clip, const Decomposition& decomposition,
                                 const Options& options = {}) {
    return detail::made<Synthesis>(stltsa_synthesize_loop, clip.get(), decomposition.get(),
                                   options.get());
}

/// What became of a clip of a batch.
struct BatchRow {
    std::string text;                 ///< for Batch::finish()
    bool kept = false;                ///< the result is of an earlier run
    stltsa_status status = STLTSA_OK; ///< why the clip failed
    std::string error;                ///< empty: it did not
};

/// Many clips, decomposed into files of a folder. Any number of threads may use it.
class Batch {
  public:
    using Pointer = stltsa_batch*;

    explicit Batch(stltsa_batch* owned) : handle_(owned) {}
    /// `shard`: "2/8"; empty: all clips.
    Batch(const std::vector<std::string>& paths, const std::string& folder,
          const std::string& shard = "", const Options& options = {})
        : Batch(detail::made<Batch>(stltsa_batch_new, detail::pointers(paths).data(),
                                    std::ssize(paths), folder.c_str(), detail::text_or_null(shard),
                                    options.get())) {}

    std::vector<std::string> paths() const {
        std::vector<std::string> paths;
        while (const char* path = stltsa_batch_path(get(), std::ssize(paths)))
            paths.emplace_back(path);
        return paths;
    }
    /// Decomposes one clip, or keeps its result. Throws only if the call is wrong or cancelled, or
    /// memory runs out. Options: progress.
    BatchRow run(std::int64_t index, const Options& options = {}) const {
        std::int32_t kept = 0;
        char* text = nullptr;
        BatchRow row;
        row.status = stltsa_batch_run(get(), index, nullptr, options.get(), &kept, &text);
        const detail::Handle<char, stltsa_free> owner(text);
        if (text == nullptr)
            detail::check(row.status);
        row.text = text;
        row.kept = kept != 0;
        row.error = row.status == STLTSA_OK ? "" : stltsa_last_error();
        return row;
    }
    /// Writes the table of the rows; returns its path.
    std::string finish(const std::vector<std::string>& rows) const {
        return detail::got<const char*>(stltsa_batch_finish, get(), detail::pointers(rows).data(),
                                        std::ssize(rows));
    }

    const stltsa_batch* get() const noexcept { return handle_.get(); }

  private:
    detail::Handle<stltsa_batch, stltsa_batch_free> handle_;
};

} // namespace v0
} // namespace stltsa

#endif // STLTSA_HPP
