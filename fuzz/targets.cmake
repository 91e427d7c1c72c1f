# Every fuzz target: a line here, fuzz/<name>.cpp, and the examples it starts from in fuzz/corpus/<name>.
set(INHABIT_FUZZ_TARGETS
  scene
  priors
  study
  wkt
  geojson
  procthor
  sweethome3d
  trajectory_text
  trajectory_hdf5
  trajectory_sqlite
)
