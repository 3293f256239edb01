#include "render/kernel/radiosity/ambient.h"

#include "render/kernel/gather/indirect_light.h"
#include "render/kernel/radiosity/gather.h"
#include "render/kernel/radiosity/lookup.h"
#include "render/kernel/context/context.h"

#include <algorithm>

namespace trace::radiosity {
namespace {

class AmbientFinder {
public:
    explicit AmbientFinder(Context& context)
        : context_(context), field_(*context.indirect->radiosity), bounce_(static_cast<std::size_t>(context.bounce)),
          rules_(field_.rules[bounce_]), scratch_(context.scratch.gather()),
          pretrace_(context.filling != nullptr && context.filling->pretrace)
    {}

    void run(std::size_t count)
    {
        HitMask open = 0;
        for (std::size_t first = 0; first < count; first += LookupGroup::kLanes)
            look_up(first, std::min(first + LookupGroup::kLanes, count));
        for (std::size_t i = 0; i < count; ++i) {
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

    bool smooth() const { return !pretrace_ && context_.bounce == 0; }
    const glm::dvec3& normal(std::size_t i) const
    {
        return field_.settings().normal ? request(i).bent : request(i).normal;
    }

    /// Requests [first, last).
    void look_up(std::size_t first, std::size_t last)
    {
        constexpr double kFull = 0.25;  // what weighs less may be less exact
        const scene::RadiositySettings& settings = field_.settings();
        LookupGroup group(smooth());
        if (only_whether()) group.stop_at(least_quarters());
        for (std::size_t i = first; i < last; ++i) {
            Lookup& to = scratch_.lookups[i] = {};
            to.bound = settings.error_bound * (pretrace_ ? settings.low_error_factor : 1.0);
            if (request(i).weight < kFull) to.bound += kFull - request(i).weight;
            to.bound *= rules_.error_factor;
            group.add(request(i).point, normal(i), to.bound);
        }
        group.ask(field_.samples[bounce_]);
        if (context_.filling != nullptr) group.ask(context_.filling->samples[bounce_]);
        for (std::size_t i = first; i < last; ++i) group.add_to(i - first, scratch_.lookups[i]);
    }

    bool enough(std::size_t i) const { return enough(scratch_.lookups[i].weight); }
    bool enough(double weight) const
    {
        if (weight > 0.0 && any_will_do()) return true;
        return 4.0 * weight >= rules_.required;
    }
    bool any_will_do() const { return context_.filling == nullptr || (!pretrace_ && !field_.settings().always_sample); }
    /// What comes of the lookups but enough() is not used: passes look at no colour of what the camera sees, and not at
    /// weights unless those tell when a part is done.
    bool only_whether() const
    {
        return context_.filling != nullptr && context_.bounce == 0 &&
               (!pretrace_ || field_.settings().adaptive_count == 0);
    }
    double least_quarters() const { return any_will_do() ? 0.0 : rules_.required; }

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
        for_each_hit(now, [&](std::size_t made) {
            if (scratch_.kept[made]) share(made, (open | now) & ~(HitMask{1} << made));
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

    /// A sample that was made for one request, for others.
    void share(std::size_t made, HitMask with)
    {
        while (with != 0) {
            LookupGroup group(smooth());
            std::array<std::size_t, LookupGroup::kLanes> of;
            for (; with != 0 && group.size() < LookupGroup::kLanes; with &= with - 1) {
                const std::size_t i = of[group.size()] = first_hit(with);
                group.add(request(i).point, normal(i), scratch_.lookups[i].bound);
            }
            group.ask(scratch_.made[made]);
            for (std::size_t k = 0; k < group.size(); ++k) group.add_to(k, scratch_.lookups[of[k]]);
        }
    }

    /// Requests that gather whatever the others' samples are worth: their rays are put in order together. In order:
    /// none before one that has to wait.
    HitMask apart(HitMask open) const
    {
        HitMask chosen = 0;
        int rays = 0;
        for (HitMask left = open; left != 0 && rays < kMostRays; left &= left - 1) {
            const std::size_t i = first_hit(left);
            double weight = scratch_.lookups[i].weight;
            for_each_hit(chosen, [&](std::size_t k) { weight += most_weight(i, k); });
            if (chosen != 0 && enough(weight)) {
                if (context_.filling->in_order) break;
                continue;
            }
            chosen |= HitMask{1} << i;
            rays += rules_.rays;
        }
        return chosen;
    }

    /// The most that a sample of request k can weigh for i; but for order, the most where nothing is nearer to it than
    /// its reach on the other side (which weighs more by rule 3 of spec 6, 4.5).
    double most_weight(std::size_t i, std::size_t k) const
    {
        const double reach = glm::distance(field_.eye, request(k).point) * rules_.most_reach;
        const double x = glm::distance(request(k).point, request(i).point) / (reach * scratch_.lookups[i].bound);
        if (x >= 1.0) return 0.0;
        if (context_.filling->in_order) return 1.0;
        if (!smooth()) return 1.0 - x;
        return x < 0.5 ? 1.0 - 2.0 * x * x : 2.0 * (1.0 - x) * (1.0 - x);
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

    static constexpr int kMostRays = 4096;

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
