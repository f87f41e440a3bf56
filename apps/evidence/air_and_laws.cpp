// SPDX-License-Identifier: MIT
/// \file  The air, and the models of which a test holds a law instead of a published figure.
#include "evidence.hpp"
#include "model/environment.hpp"

namespace eyrie::evidence {

Evidence of_air_and_laws(const std::string& /*home*/) {
  Evidence out;
  // U.S. Standard Atmosphere, 1976, table I: geometric altitude, K, Pa, kg/m3, m/s
  struct {
    double altitude, temperature, pressure, density, speed_of_sound;
  } constexpr kTable[] = {{5e3, 255.676, 5.4048e4, 0.73643, 320.545},
                          {11e3, 216.774, 2.2700e4, 0.36480, 295.154},
                          {20e3, 216.650, 5.5293e3, 0.088910, 295.069}};
  for (const auto& t : kTable) {
    const model::Air air = model::standard_air(t.altitude);
    const auto row = [&](const char* what, double here, double published) {
      out.rows.push_back(
          {.model = "atmosphere",
           .page = "atmosphere.md",
           .claim = std::string(what) + " at " +
                    std::to_string(static_cast<int>(t.altitude / 1000)) + " km",
           .here = here,
           .published = published,
           .tolerance = 2e-4,
           .source =
               "U.S. Standard Atmosphere 1976 (seen as quoted: Mechanical Engineers' Handbook)",
           .test = "StandardAir.ReproducesThePublishedTableToThePrintedDigits"});
    };
    row("temperature, K", air.temperature, t.temperature);
    row("pressure, Pa", air.pressure, t.pressure);
    row("density, kg/m³", air.density, t.density);
    row("speed of sound, m/s", air.speed_of_sound, t.speed_of_sound);
  }
  const auto law = [&](const char* model, const char* page, const char* claim, const char* source,
                       const char* test) {
    out.rows.push_back(
        {.model = model, .page = page, .claim = claim, .source = source, .test = test});
  };
  law("frames", "frames.md", "local frame against a geodesic library, 500 km", "GeographicLib",
      "Reference.KnowsHeightAndAxesWithin500Km");
  law("laero", "flight.md", "a steady turn to second order", "closed form",
      "Laero.IntegratesASteadyTurnToSecondOrder");
  law("point_mass", "flight.md", "energy without thrust and drag stays", "closed form",
      "PointMass.KeepsItsEnergyInAnyIdealManeuver");
  law("point_mass", "flight.md", "rate and radius of level turns", "closed form",
      "PointMass.TurnsAtTheRateAndRadiusOfTheClosedForm");
  law("point_mass", "flight.md", "fuel flow at part power", "JSBSim, FGTurbine (seen)",
      "Engine.BurnsMorePerThrustAtPartPower");
  law("autopilot", "flight.md", "place in formation, both dynamics", "the paper",
      "AutopilotModes.FollowTheLeadIntoTheWallFormation");
  law("radar", "radar.md", "detection by the fourth power of range", "radar equation",
      "Detector.FollowsTheFourthPowerOfRange");
  law("radar", "radar.md", "detection of a fluctuating echo by S/N", "Albersheim (1981), averaged",
      "Detector.IsTheMeanOfSteadyEchoesOverTheFluctuation");
  law("radar", "radar.md", "errors of range, angle and closing speed by S/N",
      "Barton & Leonov (1997), p. 6 (seen)",
      "LookErrors.FallWithTheRootOfTheSignalDownToTheirFloors");
  law("jammer", "radar.md", "burn-through range", "radar equation, one way and two way",
      "BurnThrough.IsWhereTheEchoIsAsGoodAsWithoutJammingAtTheOldRange");
  law("jammer", "radar.md", "directions without ranges until burn-through", "definition",
      "Jamming.HidesTheRangeUntilTheEchoBurnsThrough");
  law("jammer", "radar.md", "J/S of a repeater", "G lambda^2 / (4 pi sigma)",
      "PullOff.OfARepeaterIsTheEchoOfASectionThatIsItsGainTimesLambdaSquaredOverFourPi");
  law("jammer", "radar.md", "a lock follows a pull-off, breaks, is acquired anew",
      "Neri (1991, not seen); a t^2 / 2",
      "PulledRadar.FollowsTheFalseEchoLosesTheLockWhenThatStopsAndAcquiresAnew");
  law("jammer", "radar.md", "a seeker follows a pull-off, and finds its target again",
      "Neri (1991, not seen); a t^2 / 2",
      "PulledSeeker.FollowsTheFalseEchoLosesItWhenThatStopsAndFindsTheTargetAgain");
  law("jammer", "radar.md", "a missile sees less far under stand-off noise",
      "radar equation, one way and two way",
      "Homing.SeesLessFarUnderTheNoiseOfAJammerThatStandsOff");
  law("jammer", "radar.md", "a missile homes on jam", "definition",
      "Homing.HomesOnTheJammingWhereTheEchoDrownsInItAndKeepsTheBelievedRange");
  law("irst", "radar.md", "range by aspect and throttle, chance of detection",
      "inverse square, normal law; OLS-27 as commonly published (not seen)",
      "Infrared.FindsWithEvenOddsWhereTheSquareRootOfTheIntensitySays");
  law("tracks", "tracks.md", "NEES and NIS of targets that fly straight and turn",
      "Bar-Shalom et al. (2001), 5.4 (seen as quoted)",
      "Consistency.HoldsOfTargetsThatFlyStraightAndTurnAsTheTrackerExpects");
  law("rwr", "radar.md", "one-way range of what is heard", "radar equation",
      "EmissionFigure.IsTheOneWayRangeOfTheRadarsOwnReceiver");
  law("visual", "radar.md", "acquisition of a head-on approach",
      "Andrews, MIT Lincoln Laboratory ATC-151 (6.1 seen, values from memory)",
      "AcquisitionProbability.OfAHeadOnApproachIsTheClosedFormOfTheReport");
  law("tracks", "tracks.md", "Mahalanobis distance is chi-square",
      "Bar-Shalom et al. (2001), 5.4 (seen as quoted)",
      "Filter.MakesTheMahalanobisDistanceChiSquare");
  law("datalink", "datalink.md", "delay and loss as said", "closed form",
      "Datalink.LosesAsManyMessagesAsItSays");
  law("missile", "missile.md", "lift limit, circle of V²/a, free fall", "closed forms",
      "Flyout.TurnsOnACircleOfSpeedSquaredOverLift");
  law("missile", "missile.md", "a noise-free shot hits from all aspects",
      "Zarchan, ch. 2 (not seen)", "Steer.HitsATargetOfConstantVelocity");
  law("seeker", "missile.md", "acquisition by the fourth and the square root",
      "radar equation; inverse square",
      "AcquisitionRange.GrowsWithTheFourthRootForRadarAndTheSquareRootForInfrared");
  law("gun", "gun.md", "hits by area, range and errors", "Rayleigh distribution",
      "HitProbability.IsTheRayleighFormOfAreaRangeAndErrors");
  law("damage", "damage.md", "hits add up until they kill", "definition",
      "DamageTest.AddsUpUntilItKills");
  law("vehicle", "vehicle.md", "limits of speed, turn and acceleration", "closed form",
      "Drive.KeepsItsLimitsWhateverIsAsked");
  return out;
}

}  // namespace eyrie::evidence
