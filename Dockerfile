# The programs in a small image; tested by Buildah, as there was no Docker where this was written:
#   docker build -t boundary-recovery . && docker run --rm -v "$PWD:/data" boundary-recovery part.stl -o part.vtu
FROM debian:trixie-slim AS build
COPY . /source
RUN /source/scripts/make_packages -DBR3_BUILD_PYTHON=OFF

FROM debian:trixie-slim
COPY --from=build /source/build/packages/boundary-recovery_*.deb /tmp/
RUN apt-get update && apt-get install -y --no-install-recommends /tmp/*.deb && rm -rf /tmp/*.deb /var/lib/apt/lists/*
WORKDIR /data
ENTRYPOINT ["mesh_surface"]
