"""CHANGELOG and the recipes in packaging/, as far as they can be tested without Spack and a container:
packaging_test.py ROOT."""

import glob
import os
import re
import sys
import types
import unittest

ROOT = sys.argv.pop()


def read(*names):
    with open(os.path.join(ROOT, *names), encoding="utf-8") as file:
        return file.read()


def load_recipe():
    """The recipe with words of Spack that only note what they are told."""
    told = {"depends_on": [], "variant": [], "version": [], "conflicts": [], "license": [], "generator": []}
    module = types.ModuleType("spack.package")
    for word, list_ in told.items():
        setattr(module, word, lambda *words, list_=list_, **options: list_.append(words[0]))
    module.CMakePackage = type("CMakePackage", (), {
        "run_tests": False, "define": lambda self, name, value: f"-D{name}={value}",
        "define_from_variant": lambda self, name, variant: f"-D{name}={variant}"})
    sys.modules["spack"], sys.modules["spack.package"] = types.ModuleType("spack"), module
    names = {}
    exec(compile(read("packaging/spack/packages/percuss/package.py"), "package.py", "exec"), names)
    return names["Percuss"](), told


class Packaging(unittest.TestCase):
    def test_changes_begin_with_this_version(self):
        version = re.search(r"project\(percuss VERSION (\S+)", read("CMakeLists.txt"))[1]
        self.assertEqual(re.search(r"^## (\d+\.\d+\.\d+)", read("CHANGELOG.md"), re.M)[1], version)

    def test_python_package_has_the_version_and_all_its_files(self):
        """pip takes the folders that are packages, and of other files those that pyproject.toml names."""
        project = read("python/pyproject.toml")
        self.assertEqual(re.search(r'^version = "([^"]+)"', project, re.M)[1],
                         re.search(r"project\(percuss VERSION (\S+)", read("CMakeLists.txt"))[1])
        patterns = [f"{package.replace('.', '/')}/{name}"
                    for package, names in re.findall(r'^"(percuss[\w.]*)" = \[(.*)\]', project, re.M)
                    for name in re.findall(r'"([^"]+)"', names)]
        named = {name for pattern in patterns for name in glob.glob(pattern, root_dir=os.path.join(ROOT, "python"))}
        others = set()
        for folder, folders, names in os.walk(os.path.join(ROOT, "python/percuss")):
            folders[:] = [name for name in folders if name != "__pycache__"]
            self.assertIn("__init__.py", names, folder)
            others |= {os.path.relpath(os.path.join(folder, name), os.path.join(ROOT, "python"))
                       for name in names if not name.endswith(".py")}
        self.assertEqual(named, others)

    def test_recipe_of_spack_names_options_and_libraries_of_the_build(self):
        recipe, told = load_recipe()
        settings = read("CMakeLists.txt")
        for argument in recipe.cmake_args():
            name = re.match(r"-D(\w+)=", argument)[1]
            self.assertTrue(name == "BUILD_TESTING" or re.search(rf"(set|option)\({name} ", settings), name)
        dependencies = {re.match(r"[\w-]+", text)[0] for text in told["depends_on"]}
        sought = re.findall(r"find_package\(([\w+-]+)", read("cmake/PercussDependencies.cmake"))
        names = {"KokkosKernels": "kokkos-kernels", "nlohmann_json": "nlohmann-json", "PkgConfig": "pkgconfig",
                 "ZLIB": "zlib-api"}
        self.assertLessEqual({names.get(name, name.lower()) for name in sought}, dependencies)
        self.assertLessEqual({"metis", "seacas", "netcdf-c", "muparser"}, dependencies)

    def test_recipe_of_spack_has_the_least_versions_of_the_build(self):
        _, told = load_recipe()
        least = {match[1]: match[2]
                 for match in (re.match(r"([\w-]+)@([\d.]+):", text) for text in told["depends_on"]) if match}
        libraries = read("cmake/PercussDependencies.cmake")
        self.assertEqual(least["cmake"],
                         re.search(r"cmake_minimum_required\(VERSION ([\d.]+)\)", read("CMakeLists.txt"))[1])
        kokkos = re.search(r"Kokkos_VERSION VERSION_LESS ([\d.]+)\)", libraries)[1]
        self.assertEqual((least["kokkos"], least["kokkos-kernels"]), (kokkos, kokkos))
        self.assertEqual(least["python"],
                         re.search(r"Needs Python ([\d.]+\d)", read("python/percuss/importing/tool.py"))[1])

    def test_container_has_what_the_debian_package_recommends(self):
        recommended = re.search(r'CPACK_DEBIAN_PACKAGE_RECOMMENDS "([^"]+)"', read("CMakeLists.txt"))[1].split(", ")
        self.assertEqual([name for name in recommended if name not in read("packaging/Containerfile")], [])

    def test_container_has_packages_that_the_scripts_name(self):
        text = read("packaging/Containerfile")
        packages = set(re.findall(r"(?<![\w/-])(python3-[\w]+|libjs-three|fonts-dejavu-core|xvfb|xauth)", text))
        named = set(re.findall(r"[\w.+-]+", read("scripts/install_dependencies")))
        self.assertTrue(packages)
        self.assertLessEqual(packages, named)
        preset = re.search(r"--preset (\w+)", text)[1]
        self.assertIn(f'"name": "{preset}"', read("CMakePresets.json"))


if __name__ == "__main__":
    unittest.main()
