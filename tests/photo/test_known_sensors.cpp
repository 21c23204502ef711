// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <string>

#include "photo/known_sensors.h"

namespace parhelion {
namespace {

/// Its width, mm; 0 where the sensor is not known.
double widthOf(const std::string& make, const std::string& model) {
  Exif exif;
  exif.make = make;
  exif.model = model;
  const auto sensor = knownSensor(exif);
  return sensor ? sensor->width : 0.0;
}

}  // namespace

TEST_CASE("models whose names begin alike have the sensors that their makers state") {
  for (const char* fullFrame :
       {"Canon EOS 5D", "Canon EOS 5D Mark III", "Canon EOS 5DS R", "Canon EOS 6D Mark II", "Canon EOS R",
        "Canon EOS RP", "Canon EOS R5", "Canon EOS R6 Mark II", "Canon EOS-1Ds Mark II", "Canon EOS-1D X"}) {
    CAPTURE(std::string(fullFrame));
    CHECK(widthOf("Canon", fullFrame) == 36.0);
  }
  for (const char* apsC : {"Canon EOS 70D", "Canon EOS 7D Mark II", "Canon EOS 600D", "Canon EOS REBEL T3i",
                           "Canon EOS Kiss X5", "Canon EOS R7", "Canon EOS R10", "Canon EOS R50", "Canon EOS M50"}) {
    CAPTURE(std::string(apsC));
    CHECK(widthOf("Canon", apsC) == 22.3);
  }
  CHECK(widthOf("Canon", "Canon EOS-1D Mark IV") == 27.9);

  for (const char* fullFrame : {"NIKON D3", "NIKON D3S", "NIKON D4", "NIKON D600", "NIKON D750", "NIKON D850",
                                "NIKON Df", "NIKON Z 6", "NIKON Z6_3"}) {
    CAPTURE(std::string(fullFrame));
    CHECK(widthOf("NIKON CORPORATION", fullFrame) == 36.0);
  }
  for (const char* apsC : {"NIKON D3000", "NIKON D300S", "NIKON D40", "NIKON D60", "NIKON D500", "NIKON D7000",
                           "NIKON D7500", "NIKON D80", "NIKON Z 50", "NIKON Z fc"}) {
    CAPTURE(std::string(apsC));
    CHECK(widthOf("NIKON CORPORATION", apsC) == 23.5);
  }
  CHECK(widthOf("NIKON CORPORATION", "NIKON 1 J5") == 13.2);

  CHECK(widthOf("SONY", "ILCE-7M3") == 36.0);
  CHECK(widthOf("SONY", "ILCE-6400") == 23.5);
  CHECK(widthOf("SONY", "SLT-A77V") == 23.5);
  CHECK(widthOf("SONY", "SLT-A99V") == 36.0);
  CHECK(widthOf("SONY", "DSC-RX100M3") == 13.2);
  CHECK(widthOf("SONY", "DSC-RX1RM2") == 36.0);
  CHECK(widthOf("FUJIFILM", "X-T30") == 23.5);
  CHECK(widthOf("FUJIFILM", "X-S10") == 23.5);
  CHECK(widthOf("FUJIFILM", "X-S1") == 8.8);
  CHECK(widthOf("OLYMPUS IMAGING CORP.", "E-M10MarkII") == 17.3);
  CHECK(widthOf("Panasonic", "DMC-GH4") == 17.3);
  CHECK(widthOf("PENTAX", "PENTAX K-5") == 23.5);
  CHECK(widthOf("RICOH IMAGING COMPANY, LTD.", "PENTAX K-1 Mark II") == 36.0);
}

TEST_CASE("phones, compact cameras and models of another make are not known") {
  CHECK(widthOf("Apple", "iPhone 12") == 0.0);
  CHECK(widthOf("Canon", "Canon PowerShot G1") == 0.0);
  CHECK(widthOf("Panasonic", "DMC-LX5") == 0.0);
  CHECK(widthOf("ACME", "NIKON D750") == 0.0);
  CHECK(widthOf("", "") == 0.0);
}

TEST_CASE("sensors of full frame, APS-C, Four Thirds, one inch and phones are common, and those between are not") {
  for (const double width : {36.0, 35.6, 23.6, 23.5, 22.3, 22.7, 17.3, 13.2, 12.8, 8.0, 7.2, 6.17, 5.76, 5.0})
    CHECK(isCommonSensor(width));
  for (const double width : {60.0, 40.0, 30.0, 27.0, 20.0, 18.7, 15.0, 10.44, 9.3, 4.0, 0.1, 0.0, -36.0})
    CHECK_FALSE(isCommonSensor(width));
}

}  // namespace parhelion
