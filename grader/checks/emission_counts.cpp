#include "checks/fragment_checks.h"
#include "checks/formula.h"
#include "checks/probe_check.h"

namespace grade {

Checks check_emission_counts(Generator&) {
    using rt::Event;
    const auto inputs = [](Generator&) {
        Rows rows;
        for (const Event event : {Event::camera, Event::diffuse, Event::specular, Event::lobe, Event::medium})
            for (const bool sampled : {false, true}) rows.push_back(row(event, sampled));
        return rows;
    };
    const auto table = [](std::function<bool(Event, bool)> f) { return of<Event, bool>([f](Event e, bool sampled) { return f(e, sampled); }); };
    const std::vector<Suspect> suspects = {
        {"emission always counts: light that shadow rays have gathered counts twice at diffuse surfaces", table([](Event, bool) { return true; })},
        {"emission never counts", table([](Event, bool) { return false; })},
        {"emission counts for the camera alone: caustics and lamps in mirrors are lost", table([](Event e, bool) { return e == Event::camera; })},
        {"emitters that are not sampled are lost after a diffuse bounce: no shadow ray looks for them", table([](Event e, bool) { return e != Event::diffuse; })},
        {"sampled emitters never count: the camera and mirrors do not see them", table([](Event, bool sampled) { return !sampled; })},
        {"the test is the wrong way round", table([](Event e, bool sampled) { return e == Event::diffuse && sampled; })},
        {"sampled emitters are lost after a glossy lobe: no shadow ray was sent from there", table([](Event e, bool s) { return !s || (e != Event::diffuse && e != Event::lobe); })},
        {"sampled emitters are lost after a medium: no shadow ray was sent from there", table([](Event e, bool s) { return !s || (e != Event::diffuse && e != Event::medium); })},
        {"sampled emitters are lost behind mirrors and glass: there are no caustics", table([](Event e, bool s) { return !s || (e != Event::diffuse && e != Event::specular); })}};
    return {probe_check("table_of_events", "emission_counts", {}, inputs,
                        {formula("F5", "answers that are wrong", table([](Event e, bool sampled) { return e != Event::diffuse || !sampled; }), 1e-6, suspects)})};
}

}  // namespace grade
