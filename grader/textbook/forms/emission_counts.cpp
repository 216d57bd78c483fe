bool emission_counts(Event previous, bool sampled) { return previous != Event::diffuse || !sampled; }
