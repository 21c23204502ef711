// SPDX-License-Identifier: Apache-2.0
#include "picture/jpeg_coefficients.h"

#include <algorithm>
#include <cerrno>
#include <csetjmp>
#include <cstddef>
#include <cstdio>
#include <type_traits>

#include "picture/file_reason.h"
#include "picture/stored_picture.h"

#include <jpeglib.h>  // needs what <cstdio> declares

namespace parhelion {
namespace {

static_assert(std::is_same_v<JCOEF, std::int16_t>);

/// How libjpeg tells us of errors: a message, and a jump to the function that called it.
struct Failure {
  jpeg_error_mgr manager;  // first, so that libjpeg's pointer to it is one to this
  std::jmp_buf jump;
  char message[JMSG_LENGTH_MAX];
};

[[noreturn]] void onError(j_common_ptr library) {
  auto* failure = reinterpret_cast<Failure*>(library->err);
  failure->manager.format_message(library, failure->message);
  std::longjmp(failure->jump, 1);
}

void onMessage(j_common_ptr, int) {}  // readJpeg has judged the warnings

/// Where libjpeg writes to. Nothing is thrown through C: AtomicFile remembers its errors.
struct Destination {
  jpeg_destination_mgr manager;  // first, as above
  AtomicFile* file;
  JOCTET bytes[1 << 16];
};

void pass(j_compress_ptr target, std::size_t count) {
  auto* destination = reinterpret_cast<Destination*>(target->dest);
  try {
    destination->file->write(destination->bytes, count);
  } catch (const std::runtime_error&) {
    // commit() throws it again
  }
  destination->manager.next_output_byte = destination->bytes;
  destination->manager.free_in_buffer = sizeof destination->bytes;
}

void onStart(j_compress_ptr target) { pass(target, 0); }
boolean onFull(j_compress_ptr target) {
  pass(target, sizeof Destination::bytes);
  return TRUE;
}
void onEnd(j_compress_ptr target) { pass(target, sizeof Destination::bytes - target->dest->free_in_buffer); }

// A jump from an error lands in one of the next functions and passes over C frames only: nothing in them has a
// destructor.

bool readAll(jpeg_decompress_struct* source, Failure* failure, std::FILE* file, jvirt_barray_ptr** arrays) {
  if (setjmp(failure->jump)) return false;
  constexpr unsigned kWhole = 0xFFFF;  // bytes, more than a segment can have
  jpeg_create_decompress(source);
  jpeg_stdio_src(source, file);
  jpeg_save_markers(source, JPEG_COM, kWhole);
  for (int n = 0; n < 16; ++n) jpeg_save_markers(source, JPEG_APP0 + n, kWhole);
  jpeg_read_header(source, TRUE);
  *arrays = jpeg_read_coefficients(source);
  return true;
}

JBLOCKROW rowOf(jpeg_decompress_struct* source, Failure* failure, jvirt_barray_ptr array, JDIMENSION y) {
  if (setjmp(failure->jump)) return nullptr;
  return source->mem->access_virt_barray(reinterpret_cast<j_common_ptr>(source), array, y, 1, TRUE)[0];
}

bool isText(const jpeg_marker_struct& marker, std::string_view text) {
  return marker.data_length == text.size() && std::equal(text.begin(), text.end(), marker.data);
}

bool writeAll(jpeg_decompress_struct* source, jpeg_compress_struct* target, Failure* failure,
              jpeg_destination_mgr* destination, jvirt_barray_ptr* arrays, std::string_view comment) {
  if (setjmp(failure->jump)) return false;
  jpeg_create_compress(target);
  target->dest = destination;
  jpeg_copy_critical_parameters(source, target);
  target->write_JFIF_header = FALSE;  // they are among the markers, if they were there
  target->write_Adobe_marker = FALSE;
  target->optimize_coding = TRUE;
  if (source->progressive_mode) jpeg_simple_progression(target);
  jpeg_write_coefficients(target, arrays);
  for (jpeg_saved_marker_ptr m = source->marker_list; m; m = m->next) {
    jpeg_write_marker(target, m->marker, m->data, m->data_length);
    if (m->marker == JPEG_COM && isText(*m, comment)) comment = {};
  }
  if (!comment.empty()) {
    jpeg_write_marker(target, JPEG_COM, reinterpret_cast<const JOCTET*>(comment.data()),
                      static_cast<unsigned>(comment.size()));
  }
  jpeg_finish_compress(target);
  return true;
}

struct Close {
  void operator()(std::FILE* file) const { std::fclose(file); }
};

}  // namespace

struct JpegCoefficients::Library {
  Failure failure{};
  jpeg_decompress_struct source{};
  jvirt_barray_ptr* arrays = nullptr;

  Library() {
    source.err = jpeg_std_error(&failure.manager);
    failure.manager.error_exit = onError;
    failure.manager.emit_message = onMessage;
  }
  ~Library() { jpeg_destroy_decompress(&source); }
  Library(const Library&) = delete;
  Library& operator=(const Library&) = delete;

  std::runtime_error error(const std::filesystem::path& path) const {
    return pictureError(path, std::string("JPEG: ") + failure.message);
  }
};

JpegCoefficients::JpegCoefficients(const std::filesystem::path& path)
    : path_(path), library_(std::make_unique<Library>()) {
  const std::unique_ptr<std::FILE, Close> file(std::fopen(path.c_str(), "rbe"));
  if (!file) throw pictureError(path, reasonFor(path, errno));
  jpeg_decompress_struct& source = library_->source;
  if (!readAll(&source, &library_->failure, file.get(), &library_->arrays)) throw library_->error(path);
  for (int i = 0; i < source.num_components; ++i) {
    const jpeg_component_info& info = source.comp_info[i];
    Component component{source.max_h_samp_factor / info.h_samp_factor,
                        source.max_v_samp_factor / info.v_samp_factor,
                        static_cast<int>(info.width_in_blocks),
                        static_cast<int>(info.height_in_blocks),
                        {}};
    if (info.quant_table) std::copy_n(info.quant_table->quantval, 64, component.steps.begin());
    components_.push_back(component);
  }
}

JpegCoefficients::~JpegCoefficients() = default;

int JpegCoefficients::width() const { return static_cast<int>(library_->source.image_width); }
int JpegCoefficients::height() const { return static_cast<int>(library_->source.image_height); }
bool JpegCoefficients::isRgb() const { return library_->source.jpeg_color_space == JCS_RGB; }

bool JpegCoefficients::repeatable() const {
  const jpeg_decompress_struct& source = library_->source;
  for (int i = 0; i < source.num_components; ++i) {
    const JQUANT_TBL* first = source.comp_info[i].quant_table;
    const JQUANT_TBL* last = source.quant_tbl_ptrs[source.comp_info[i].quant_tbl_no];
    if (!first || !last || !std::equal(first->quantval, first->quantval + 64, last->quantval)) return false;
    if (std::count(first->quantval, first->quantval + 64, 0) > 0) return false;
    // The number of bits still missing, -1 where all are; sequential files have no such list.
    if (source.coef_bits && std::count(source.coef_bits[i], source.coef_bits[i] + 64, 0) < 64) return false;
  }
  return true;
}

std::int16_t* JpegCoefficients::row(std::size_t component, int y) {
  const JBLOCKROW blocks =
      rowOf(&library_->source, &library_->failure, library_->arrays[component], static_cast<JDIMENSION>(y));
  if (!blocks) throw library_->error(path_);
  return blocks[0];
}

void JpegCoefficients::write(AtomicFile& file, std::string_view comment) {
  const auto destination = std::make_unique<Destination>();
  destination->manager.init_destination = onStart;
  destination->manager.empty_output_buffer = onFull;
  destination->manager.term_destination = onEnd;
  destination->file = &file;
  jpeg_compress_struct target{};
  target.err = &library_->failure.manager;
  const bool complete =
      writeAll(&library_->source, &target, &library_->failure, &destination->manager, library_->arrays, comment);
  jpeg_destroy_compress(&target);
  if (!complete) throw library_->error(path_);
}

}  // namespace parhelion
