#include "render/trace/radiosity/ambient.h"

#include "render/trace/indirect/indirect_light.h"
#include "render/trace/radiosity/gather.h"
#include "render/trace/radiosity/lookup.h"
#include "render/trace/shade/shade_context.h"

#include <algorithm>

namespace trace::radiosity {
namespace {

class AmbientFinder {
public:
    explicit AmbientFinder(Context& context)
        : context_(context), field_(*context.indirect->radiosity), bounce_(static_cast<std::size_t>(context.bounce)),
          rules_(field_.rules[bounce_]), scratch_(*context.scratch.gather),
          pretrace_(context.filling != nullptr && context.filling->pretrace)
    {}

    void run(std::size_t count)
    {
        HitMask open = 0;
        for (std::size_t i = 0; i < count; ++i) {
            look_up(i);
            if (!enough(i)) open |= HitMask{1} << i;
            else answer(i, nullptr);
        }
        if (context_.filling == nullptr) {
            if (open != 0) gather(context_, open);
            for_each_hit(open, [&](std::size_t i) { answer(i, &scratch_.made[i]); });
            return;
        }
        while (open != 0) open = make_samples(open);
    }

private:
    const Request& request(std::size_t i) const { return scratch_.requests[i]; }

    Query query(std::size_t i) const
    {
        const Request& of = request(i);
        return {of.point, field_.settings().normal ? of.bent : of.normal, scratch_.lookups[i].bound,
                !pretrace_ || context_.bounce == 0};
    }

    void look_up(std::size_t i)
    {
        constexpr double kFull = 0.25;  // what weighs less may be less exact
        const scene::RadiositySettings& settings = field_.settings();
        Lookup& to = scratch_.lookups[i] = {};
        to.bound = settings.error_bound * (pretrace_ ? settings.low_error_factor : 1.0);
        if (request(i).weight < kFull) to.bound += kFull - request(i).weight;
        to.bound *= rules_.error_factor;
        const Query q = query(i);
        radiosity::look_up(field_.samples[bounce_], q, to);
        if (context_.filling != nullptr) radiosity::look_up(context_.filling->samples[bounce_], q, to);
    }

    bool enough(std::size_t i) const
    {
        const double weight = scratch_.lookups[i].weight;
        if (weight > 0.0 && (context_.filling == nullptr || (!pretrace_ && !field_.settings().always_sample)))
            return true;
        return 4.0 * weight >= rules_.required;
    }

    /// Samples for some of the requests, which then serve the others too; what is still open.
    HitMask make_samples(HitMask open)
    {
        const HitMask now = apart(open);
        gather(context_, now);
        open &= ~now;
        for_each_hit(now, [&](std::size_t i) {
            if (!scratch_.kept[i]) return;
            const Found found{context_.bounce, scratch_.made[i]};
            context_.filling->found.push_back(found);
            field_.add(found, context_.filling->samples);
        });
        for_each_hit(open, [&](std::size_t i) {
            const Query q = query(i);
            for_each_hit(now, [&](std::size_t made) {
                if (scratch_.kept[made]) use(scratch_.made[made], q, scratch_.lookups[i]);
            });
        });
        for_each_hit(now, [&](std::size_t i) { answer(i, &scratch_.made[i]); });
        for (HitMask left = open; left != 0; left &= left - 1) {
            const std::size_t i = first_hit(left);
            if (!enough(i)) continue;
            answer(i, nullptr);
            open &= ~(HitMask{1} << i);
        }
        return open;
    }

    /// Requests that will hardly share a sample: their rays fill tiles together.
    HitMask apart(HitMask open) const
    {
        HitMask chosen = 0;
        int rays = 0;
        for (HitMask left = open; left != 0 && rays < kTileRays; left &= left - 1) {
            const std::size_t i = first_hit(left);
            const double away = glm::distance(field_.eye, request(i).point) * kApart * rules_.most_reach;
            bool alone = true;
            for_each_hit(chosen, [&](std::size_t k) {
                alone = alone && glm::distance(request(k).point, request(i).point) > away;
            });
            if (!alone) continue;
            chosen |= HitMask{1} << i;
            rays += rules_.rays;
        }
        return chosen;
    }

    /// made: a sample that was gathered for this request.
    void answer(std::size_t i, const Sample* made)
    {
        Lookup& found = scratch_.lookups[i];
        float& quality = context_.scratch.shade.quality[request(i).root];
        if (made != nullptr) {
            const auto q = static_cast<double>(made->quality);
            if (found.weight > 0.0) {
                found.sum += q * glm::dvec3(made->color);
            } else {
                found.sum = q > 0.0 ? q * glm::dvec3(made->color) : glm::dvec3(made->color);
            }
            found.weight += q;
            quality = std::max(quality, made->quality);
        }
        quality = std::min(quality, static_cast<float>(4.0 * found.weight / rules_.required));
        if (context_.filling != nullptr && context_.bounce == 0) {
            context_.filling->weight[request(i).root] += static_cast<float>(4.0 * found.weight);
            ++context_.filling->asked[request(i).root];
        }
        const scene::RadiositySettings& settings = field_.settings();
        const glm::vec3 mean(found.weight > 0.0 ? found.sum / found.weight : found.sum);
        const auto gray = static_cast<float>(settings.gray_threshold);
        scratch_.ambient[i] = ((1.0f - gray) * mean + gray * scene::grey(mean)) *
                              static_cast<float>(settings.brightness);
    }

    static constexpr double kApart = 0.5;

    Context& context_;
    const Field& field_;
    std::size_t bounce_;
    const BounceRules& rules_;
    GatherScratch& scratch_;
    bool pretrace_;
};

}  // namespace

void find_ambient(Context& context, std::size_t count) { AmbientFinder(context).run(count); }

}  // namespace trace::radiosity
