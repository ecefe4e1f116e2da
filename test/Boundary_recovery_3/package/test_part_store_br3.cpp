// What `mesh_surface_mpi` keeps on the disk: a file that is not whole, or of another run, is never taken.

#undef NDEBUG
#include <cassert>

#include "part_store.h"

#include <sys/resource.h>
#include <unistd.h>

#include <csignal>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <stdexcept>
#include <string>

const std::uint64_t key = 0x0123456789abcdefu;

Bytes contents(const std::string& name)
{
  std::ifstream is(name, std::ios::binary);
  return Bytes(std::istreambuf_iterator<char>(is), std::istreambuf_iterator<char>());
}

void replace(const std::string& name, const Bytes& bytes)
{
  std::ofstream os(name, std::ios::binary | std::ios::trunc);
  os.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  assert(os.flush());
}

std::size_t number_of_files(const std::string& folder)
{
  const std::filesystem::directory_iterator files(folder);
  return static_cast<std::size_t>(std::distance(begin(files), end(files)));
}

Bytes some_result(const std::size_t n)
{
  Bytes bytes;
  for(std::size_t i = 0; i < n; ++i)
    bytes.push_back(static_cast<char>(i * i + 7));
  return bytes;
}

void test_what_is_saved_is_loaded(const std::string& folder)
{
  for(const bool is_durable : { false, true })
  {
    const Part_store store(folder, key, is_durable);
    Bytes loaded;
    assert(! store.load("a", 0, loaded));
    for(const std::size_t n : { 0, 1, 1000, 300000 })
    {
      store.save("a", { some_result(n), some_result(3), some_result(2 * n) }); // in the place of the one before
      assert(store.load("a", 0, loaded) && loaded == some_result(n));
      assert(store.load("a", 1, loaded) && loaded == some_result(3));
      assert(store.load("a", 2, loaded) && loaded == some_result(2 * n));
      assert(! store.load("a", 3, loaded));
      assert(number_of_files(folder) == 1);
    }
    store.save("nothing", { });
    assert(! store.load("nothing", 0, loaded));
    store.remove("a");
    store.remove("nothing");
    assert(! store.load("a", 0, loaded) && number_of_files(folder) == 0);
  }
}

void test_foreign_results(const std::string& folder)
{
  const Part_store store(folder, key, true), other_run(folder, key + 1, true);
  store.save("a", { some_result(50) });
  Bytes loaded;
  assert(! store.load("b", 0, loaded) && ! other_run.load("a", 0, loaded));
  std::filesystem::copy_file(store.file_of("a"), store.file_of("b")); // under names that are not theirs
  std::filesystem::copy_file(store.file_of("a"), other_run.file_of("a"));
  assert(! store.load("b", 0, loaded) && ! other_run.load("a", 0, loaded) && store.load("a", 0, loaded));
}

// A record that is loaded is as it was saved, whatever happened to the file.
void test_damaged_files(const std::string& folder)
{
  const Part_store store(folder, key, true);
  store.save("a", { some_result(43), some_result(60) });
  const std::string name = store.file_of("a");
  const Bytes whole = contents(name);
  Bytes loaded;
  for(std::size_t n = 0; n < whole.size(); ++n)
  {
    replace(name, Bytes(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(n)));
    assert(! store.load("a", 0, loaded) && ! store.load("a", 1, loaded));
  }
  const std::size_t begin_of_records = whole.size() - 43 - 60;
  for(std::size_t i = 0; i < whole.size(); ++i)
    for(int bit = 0; bit < 8; ++bit)
    {
      Bytes damaged = whole;
      damaged[i] = static_cast<char>(damaged[i] ^ (1 << bit));
      replace(name, damaged);
      const bool is_first_damaged = i < begin_of_records + 43;
      const bool is_second_damaged = i < begin_of_records || ! is_first_damaged;
      assert(store.load("a", 0, loaded) == ! is_first_damaged && (is_first_damaged || loaded == some_result(43)));
      assert(store.load("a", 1, loaded) == ! is_second_damaged && (is_second_damaged || loaded == some_result(60)));
    }
  Bytes longer = whole;
  longer.push_back(0);
  replace(name, longer);
  assert(! store.load("a", 0, loaded));
  replace(name, whole);
  assert(store.load("a", 1, loaded) && loaded == some_result(60));
}

template <typename Function>
std::string message_of(const Function& f)
{
  try
  {
    f();
  }
  catch(const std::runtime_error& e)
  {
    return e.what();
  }
  return std::string();
}

void test_what_cannot_be_written(const std::string& folder)
{
  std::filesystem::create_directories(folder);
  const std::string file = folder + "/a_file";
  replace(file, some_result(1));
  assert(message_of([&] { Part_store(file, key, true); }) == "cannot make the folder " + file);

  const Part_store store(folder, key, true);
  std::filesystem::create_directories(store.file_of("b") + "/in_the_way"); // so that it cannot get its name
  assert(message_of([&] { store.save("b", { some_result(9) }); }).find("cannot write " + store.file_of("b")) == 0);
  Bytes loaded;
  assert(! store.load("b", 0, loaded));

  rlimit limit = {};
  getrlimit(RLIMIT_FSIZE, &limit);
  const rlimit previous = limit;
  limit.rlim_cur = 1000; // a disk that becomes full
  std::signal(SIGXFSZ, SIG_IGN);
  setrlimit(RLIMIT_FSIZE, &limit);
  const std::string message = message_of([&] { store.save("c", { some_result(2000) }); });
  setrlimit(RLIMIT_FSIZE, &previous);
  assert(message.find("cannot write " + store.file_of("c")) == 0);
  assert(! store.load("c", 0, loaded));
  assert(number_of_files(folder) == 2); // nothing unfinished is left
}

// arrays that announce more than there is
void test_byte_reader()
{
  Bytes bytes;
  Byte_writer writer(bytes);
  writer.put(1.5);
  writer.put(std::vector<int>{ 1, 2, 3 });
  for(std::size_t n = 0; n <= bytes.size(); ++n)
  {
    const Bytes cut(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(n));
    const std::string message = message_of([&]
    {
      Byte_reader reader(cut);
      std::vector<int> v;
      assert(reader.get<double>() == 1.5);
      reader.get(v);
      assert(v == std::vector<int>({ 1, 2, 3 }) && reader.is_at_end());
    });
    assert(message.empty() == (n == bytes.size()));
  }
}

int main()
{
  const std::string root =
    (std::filesystem::temp_directory_path() / ("part_store_br3_" + std::to_string(::getpid()))).string();
  int number = 0;
  for(const auto& test : { test_what_is_saved_is_loaded, test_foreign_results, test_damaged_files,
                           test_what_cannot_be_written })
    test(root + "/" + std::to_string(++number));
  std::filesystem::remove_all(root);
  test_byte_reader();
  std::cout << "done" << std::endl;
  return 0;
}
